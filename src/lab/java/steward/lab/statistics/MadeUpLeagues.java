package steward.lab.statistics;

import java.util.List;

/** The leagues that are played to see what bars promise. */
final class MadeUpLeagues {

    private static MadeUpLeague two(double elo) {
        return MadeUpLeague.pairs("2 bots, " + Math.round(elo) + " Elo apart", new double[] {elo, 0}, 0, 0, 0, 0);
    }

    static List<MadeUpLeague> small() {
        return List.of(two(0), two(100), two(300), two(400), two(480), two(550), two(700), two(800), two(1200),
            MadeUpLeague.pairs("2 bots, ties", new double[] {60, 0}, 0.8, 0, 0, 0),
            MadeUpLeague.pairs("2 bots, ties, seeds of 150 Elo", new double[] {60, 0}, 0.5, 50, 150, 0),
            MadeUpLeague.pairs("2 bots, ties, sides of 300 Elo", new double[] {60, 0}, 0.5, 300, 0, 0),
            trio(), mixed(), MadeUpLeague.threes("5 bots, 3 players, seeds of 60 Elo", 60, MadeUpLeague.spaced(5, 60)),
            MadeUpLeague.alone("4 bots, each alone", MadeUpLeague.spaced(4, 60)),
            MadeUpLeague.sharing("5 bots, one against all on one list of seeds, seeds of 150 Elo", 150,
                MadeUpLeague.spaced(5, 60), new int[][] {{0, 1}, {0, 2}, {0, 3}, {0, 4}}),
            MadeUpLeague.sharing("4 bots, all on one list of seeds, seeds of 150 Elo", 150,
                MadeUpLeague.spaced(4, 60), new int[][] {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}));
    }

    static MadeUpLeague trio() {
        return MadeUpLeague.pairs("3 bots, rock, paper, scissors of 150 Elo", MadeUpLeague.spaced(3, 0), 0.1, 0, 0,
            150);
    }

    static MadeUpLeague mixed() {
        return MadeUpLeague.pairs("6 bots, three of them in a circle, ties, seeds, sides", MadeUpLeague.spaced(6, 40),
            0.3, 30, 60, 100);
    }

    static MadeUpLeague large() {
        return MadeUpLeague.pairs("30 bots, ties, seeds of 60 Elo", MadeUpLeague.spaced(30, 20), 0.1, 0, 60, 0);
    }

    static MadeUpLeague threes() {
        return MadeUpLeague.threes("5 bots, 3 players", 0, MadeUpLeague.spaced(5, 60));
    }

    /** Returns the leagues whose pairing matters. */
    static List<MadeUpLeague> paired() {
        return List.of(trio(), mixed(), threes());
    }

    /** Returns the leagues in which one wins nearly everything. */
    static List<MadeUpLeague> won() {
        return List.of(two(1500), MadeUpLeague.pairs("5 bots, one 1400 Elo ahead",
            new double[] {1500, 100, 0, -100, -200}, 0.1, 0, 0, 0));
    }

    /** 16 bots, by the steps in Elo between neighbours. */
    static MadeUpLeague sixteen(double... steps) {
        double[] elo = new double[steps.length + 1];
        for (int k = 0; k < steps.length; k++) {
            elo[k + 1] = elo[k] - steps[k];
        }
        return MadeUpLeague.pairs("16 bots", elo, 0.3, 20, 50, 0);
    }
}
