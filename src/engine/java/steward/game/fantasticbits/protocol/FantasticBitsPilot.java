package steward.game.fantasticbits.protocol;

import java.util.StringJoiner;
import steward.game.Game;
import steward.game.Pilot;
import steward.game.fantasticbits.EntityKind;
import steward.game.fantasticbits.FantasticBits;
import steward.game.fantasticbits.Pitch;
import steward.game.fantasticbits.Spell;
import steward.game.fantasticbits.WizardCommand;
import steward.numerics.SplitMix64;
import steward.physics.Bodies;

/**
 * Pilot of wizards by rule: each heads for the nearest snaffle and throws it at the goal; now and then a spell.
 * Gathering wizards head for the middle; mingling ones for anywhere on the pitch.
 */
record FantasticBitsPilot(Aim aim) implements Pilot {

    /** One of this many commands is a spell. */
    private static final int SPELLS = 8;
    /** The most by which a pilot misses its target along each axis, in u. */
    private static final int AIM = 200;

    @Override
    public String answer(Game game, int player, SplitMix64 random) {
        FantasticBits of = (FantasticBits) game;
        StringJoiner all = new StringJoiner(",", "{\"wizards\":[", "]}");
        for (int wizard = 0; wizard < Pitch.WIZARDS_PER_PLAYER; wizard++) {
            all.add(command(of, player, wizard, random));
        }
        return all.toString();
    }

    private String command(FantasticBits game, int player, int wizard, SplitMix64 random) {
        Pitch pitch = game.pitch();
        int self = player * Pitch.WIZARDS_PER_PLAYER + wizard;
        boolean holds = pitch.held(self) >= 0;
        boolean casts = random.nextInt(SPELLS) == 0;
        Spell spell = Spell.of(random.nextInt(Spell.count()));
        int target = random.nextInt(pitch.entities());
        double[] goal = goal(pitch, player, self, random);
        long x = Math.round(goal[0]) + random.nextInt(-AIM, AIM);
        long y = Math.round(goal[1]) + random.nextInt(-AIM, AIM);
        int power = random.nextInt(WizardCommand.MOST_THRUST / 2, WizardCommand.MOST_THRUST);
        if (casts && game.refusal(player, wizard, WizardCommand.cast(spell, target)) == null) {
            return "{\"spell\":\"" + spell.text() + "\",\"target\":" + target + "}";
        }
        return "{\"x\":" + x + ",\"y\":" + y + (holds ? ",\"throw\":" + 3 * power + "}" : ",\"power\":" + power + "}");
    }

    private double[] goal(Pitch pitch, int player, int self, SplitMix64 random) {
        if (aim == Aim.MINGLE) {
            return new double[] {random.nextInt((int) Pitch.WIDTH), random.nextInt((int) Pitch.HEIGHT)};
        }
        if (aim == Aim.GATHER) {
            return new double[] {Pitch.WIDTH / 2, Pitch.HEIGHT / 2};
        }
        if (pitch.held(self) >= 0) {
            return new double[] {player == 0 ? Pitch.WIDTH : 0, Pitch.HEIGHT / 2};
        }
        Bodies bodies = pitch.bodies();
        int nearest = Pilot.nearest(bodies, self, k -> k >= Pitch.WIZARDS && k < Pitch.WIZARDS + pitch.snaffles()
            && pitch.kind(k) != EntityKind.LOST_SNAFFLE);
        return nearest < 0 ? new double[] {Pitch.WIDTH / 2, Pitch.HEIGHT / 2}
            : new double[] {bodies.x[nearest], bodies.y[nearest]};
    }
}
