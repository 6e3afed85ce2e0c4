package steward.game.pokerchiprace.protocol;

import java.util.StringJoiner;
import steward.game.Game;
import steward.game.Pilot;
import steward.game.pokerchiprace.ChipTable;
import steward.game.pokerchiprace.PokerChipRace;
import steward.numerics.SplitMix64;
import steward.physics.Bodies;

/**
 * Pilot of chips by rule: now and then each is pushed toward the nearest smaller chip. Gathering chips head for the
 * centre; mingling ones for anywhere on the table.
 */
record PokerChipRacePilot(Aim aim) implements Pilot {

    /** One of this many commands is a push. */
    private static final int PUSHES = 4;
    /** The most by which a pilot misses its target along each axis, in u. */
    private static final int AIM = 10;

    @Override
    public String answer(Game game, int player, SplitMix64 random) {
        ChipTable table = ((PokerChipRace) game).table();
        StringJoiner all = new StringJoiner(",", "{\"chips\":[", "]}");
        for (int k = 0; k < table.owned(player); k++) {
            double[] goal = goal(table, table.ownChip(player, k), random);
            long x = Math.round(goal[0]) + random.nextInt(-AIM, AIM);
            long y = Math.round(goal[1]) + random.nextInt(-AIM, AIM);
            boolean waits = random.nextInt(PUSHES) != 0;
            all.add(waits ? "{\"wait\":true}" : "{\"x\":" + x + ",\"y\":" + y + "}");
        }
        return all.toString();
    }

    private double[] goal(ChipTable table, int self, SplitMix64 random) {
        if (aim == Aim.MINGLE) {
            int farX = (int) ChipTable.HALF_WIDTH;
            int farY = (int) ChipTable.HALF_HEIGHT;
            return new double[] {random.nextInt(-farX, farX), random.nextInt(-farY, farY)};
        }
        Bodies bodies = table.bodies();
        int nearest = aim == Aim.GATHER ? -1
            : Pilot.nearest(bodies, self, chip -> bodies.radius[chip] < bodies.radius[self]);
        return nearest < 0 ? new double[2] : new double[] {bodies.x[nearest], bodies.y[nearest]};
    }
}
