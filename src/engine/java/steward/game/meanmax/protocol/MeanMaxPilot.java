package steward.game.meanmax.protocol;

import java.util.StringJoiner;
import steward.game.Game;
import steward.game.Pilot;
import steward.game.meanmax.MeanMax;
import steward.game.meanmax.MeanMaxWorld;
import steward.game.meanmax.Skill;
import steward.game.meanmax.UnitKind;
import steward.numerics.SplitMix64;
import steward.physics.Bodies;

/**
 * Pilot of looters by rule: destroyers head for tankers, reapers for wrecks, doofs for reapers of others; now and then
 * a skill. Gathering looters head for the centre; mingling ones for anywhere in the arena.
 */
record MeanMaxPilot(Aim aim) implements Pilot {

    /** One of this many commands is a skill. */
    private static final int SKILLS = 8;
    /** The most by which a pilot misses its target along each axis, in u. */
    private static final int AIM = 200;
    private static final int MOST_POWER = 300;

    @Override
    public String answer(Game game, int player, SplitMix64 random) {
        MeanMax of = (MeanMax) game;
        StringJoiner all = new StringJoiner(",", "{\"looters\":[", "]}");
        for (int looter = 0; looter < UnitKind.LOOTERS; looter++) {
            if (looter >= of.settings().looters()) {
                all.add("{\"wait\":true}");
                continue;
            }
            double[] goal = goal(of, player, looter, random);
            long x = Math.round(goal[0]) + random.nextInt(-AIM, AIM);
            long y = Math.round(goal[1]) + random.nextInt(-AIM, AIM);
            Skill skill = UnitKind.of(looter).skill();
            boolean casts = random.nextInt(SKILLS) == 0 && of.settings().isActive(skill)
                && of.rage(player) >= skill.cost();
            int power = random.nextInt(MOST_POWER / 2, MOST_POWER);
            all.add("{\"x\":" + x + ",\"y\":" + y + (casts ? ",\"skill\":true}" : ",\"power\":" + power + "}"));
        }
        return all.toString();
    }

    private double[] goal(MeanMax game, int player, int looter, SplitMix64 random) {
        MeanMaxWorld world = game.world();
        Bodies bodies = game.bodies();
        int self = world.looter(player, looter);
        if (aim == Aim.MINGLE) {
            int far = (int) MeanMaxWorld.ARENA_RADIUS;
            return new double[] {random.nextInt(-far, far), random.nextInt(-far, far)};
        }
        if (aim == Aim.GATHER) {
            return new double[2];
        }
        if (looter == UnitKind.REAPER.ordinal() && !world.wrecks().isEmpty()) {
            return new double[] {world.wrecks().get(0).x(), world.wrecks().get(0).y()};
        }
        int nearest = Pilot.nearest(bodies, self, unit -> looter == UnitKind.DOOF.ordinal()
            ? bodies.kind[unit] == UnitKind.REAPER.ordinal() && game.playerOf(bodies.id(unit)) != player
            : world.isTanker(unit));
        return nearest < 0 ? new double[2] : new double[] {bodies.x[nearest], bodies.y[nearest]};
    }
}
