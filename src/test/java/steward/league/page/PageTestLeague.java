package steward.league.page;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import steward.league.Season;
import steward.league.StoredGame;
import steward.league.rating.LeagueTable;
import steward.league.rating.RatingPath;
import steward.league.rating.Results;

/** A made-up league: bots whose strengths lie evenly, games drawn by lot from a seed. */
public final class PageTestLeague {

    /** Elo from one bot to the next. */
    private static final double STEP = 35;
    private static final int LISTED = 40;
    private static final int POINTS = 40;

    private PageTestLeague() {
    }

    /**
     * Plays it.
     *
     * @param bots   how many
     * @param rounds games of every two bots
     */
    public static LeagueView of(int bots, int rounds) {
        SplittableRandom random = new SplittableRandom(7);
        List<LeagueTable.Entry> entries = new ArrayList<>();
        for (int version = 1; version <= bots; version++) {
            entries.add(new LeagueTable.Entry(version, "bot-" + version, version == 3, version != bots));
        }
        Season season = Season.of("mad-pod-racing", "key", "limits", "rules", 2, false);
        Results results = new Results(season);
        RatingPath.Collector path = new RatingPath.Collector(entries, LeagueTable.Reference.NONE);
        List<StoredGame> games = new ArrayList<>();
        int all = rounds * bots * (bots - 1) / 2;
        for (int round = 0; round < rounds; round++) {
            for (int one = 1; one <= bots; one++) {
                for (int other = one + 1; other <= bots; other++) {
                    boolean won = random.nextDouble() < 1 / (1 + Math.pow(10, (one - other) * STEP / 400));
                    boolean failed = random.nextInt(40) == 0;
                    String fault = failed ? "no answer within 75 ms: computed 75.0" : null;
                    results.addGame(games.size(), new int[] {one, other}, won ? 0 : 1, won ? 1 : 0);
                    results.addSums(one, 1, won ? 12 : 7, failed && !won ? 1 : 0, 100, 300_000 * one, 9_000_000);
                    results.addSums(other, 1, won ? 7 : 12, failed && won ? 1 : 0, 100, 300_000 * other, 9_000_000);
                    games.add(0, new StoredGame(games.size() + 1, new byte[0], 0, games.size(), 1, true, 128, null, 0,
                        "here", null, 0, List.of(seat(one, won, fault), seat(other, !won, fault))));
                    if (games.size() % Math.max(1, all / POINTS) == 0) {
                        path.take(results);
                    }
                }
            }
        }
        return new LeagueView(season, LeagueTable.of(results, entries), path.path(),
            games.subList(0, Math.min(LISTED, games.size())), Double.NaN, List.of());
    }

    private static StoredGame.StoredSeat seat(int version, boolean won, String fault) {
        return new StoredGame.StoredSeat(version, won ? 0 : 1, won ? 12 : 7, won ? null : fault, 100, 300_000,
            9_000_000, 9_000_000);
    }
}
