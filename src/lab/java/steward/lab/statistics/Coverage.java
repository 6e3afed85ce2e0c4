package steward.lab.statistics;

import java.util.Locale;

/**
 * Coverage of the bars of differences, by pairing: the share of leagues in which the truth was within.
 *
 * @param leagues how many were played
 * @param least   the lowest share over pairings whose expected score is in 5..95%; NaN if there is none
 * @param most    the highest, likewise
 * @param outer   the lowest over the others, likewise
 */
record Coverage(long leagues, double least, double most, double outer) {

    private static final double EXTREME = 0.05;

    /** Differences of ratings. */
    enum Among {
        /** All. */
        ALL,
        /** Differences to the bot against which all others play. */
        WITH_HERO,
        /** Differences of two others. */
        OTHERS
    }

    /**
     * From counts.
     *
     * @param inside by pairing, in the order (0,1), (0,2), ...
     */
    static Coverage of(MadeUpLeague league, long leagues, long... inside) {
        return of(league, Among.ALL, leagues, inside);
    }

    /** Returns the coverage among some differences, from counts. */
    static Coverage of(MadeUpLeague league, Among among, long leagues, long... inside) {
        double least = Double.NaN;
        double most = Double.NaN;
        double outer = Double.NaN;
        int pair = 0;
        for (int i = 0; i < league.bots(); i++) {
            for (int j = i + 1; j < league.bots(); j++) {
                double share = (double) inside[pair++] / leagues;
                boolean hero = i == league.hero() || j == league.hero();
                if (among != Among.ALL && hero != (among == Among.WITH_HERO)) {
                    continue;
                }
                double score = league.truth().expected(i, j);
                if (score < EXTREME || score > 1 - EXTREME) {
                    outer = Double.isNaN(outer) ? share : Math.min(outer, share);
                } else {
                    least = Double.isNaN(least) ? share : Math.min(least, share);
                    most = Double.isNaN(most) ? share : Math.max(most, share);
                }
            }
        }
        return new Coverage(leagues, least, most, outer);
    }

    static String percent(double share) {
        return Double.isNaN(share) ? "-" : String.format(Locale.ROOT, "%.2f", 100 * share);
    }
}
