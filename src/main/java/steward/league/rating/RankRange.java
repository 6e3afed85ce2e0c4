package steward.league.rating;

/**
 * The ranks that the games leave a bot, with 95%: the bars of its differences to all others hold together (Bonferroni).
 *
 * @param best  the best of them, from 1
 * @param worst the worst
 */
public record RankRange(int best, int worst) {

    /** Half the probability that a rank is outside of its range. */
    private static final double TAIL = 0.025;

    /** That of a bot of a fit, by its place there. */
    public static RankRange of(RatingFit fit, int bot) {
        int bots = fit.bots();
        int best = 1;
        int worst = bots;
        double z = Normal.above(TAIL / Math.max(1, bots - 1));
        for (int other = 0; other < bots; other++) {
            if (other != bot) {
                Difference difference = fit.difference(bot, other);
                boolean sure = Math.abs(difference.elo()) > difference.bar(z);
                best += sure && difference.elo() < 0 ? 1 : 0;
                worst -= sure && difference.elo() > 0 ? 1 : 0;
            }
        }
        return new RankRange(best, worst);
    }
}
