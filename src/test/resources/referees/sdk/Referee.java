import java.util.Random;

/** A project for the stand-in: chance from the seed, a static that remembers, and a fault of each kind by the seed. */
public class Referee {

    private static int remembered;

    public static String turn(int turn, long seed, int games) throws Exception {
        if (turn == 2 && seed == 101) {
            System.err.println("leaving");
            System.exit(7);
        }
        if (turn == 2 && seed == 102) {
            throw new IllegalStateException("no such cell");
        }
        if (turn == 2 && seed == 103) {
            Thread.sleep(1000000);
        }
        remembered++;
        return "chance " + new Random(seed + turn).nextInt(1000) + " remembered " + remembered
            + (seed >= 100 ? " game " + games : "");
    }
}
