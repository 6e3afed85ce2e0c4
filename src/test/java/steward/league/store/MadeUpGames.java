package steward.league.store;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import steward.cli.league.view.LeagueOpening;
import steward.contest.seeds.Seeds;
import steward.league.Decision;
import steward.league.GameName;
import steward.league.LeagueFolder;
import steward.league.LeagueSettings;
import steward.league.PausedBots;
import steward.league.Schedule;
import steward.league.Season;
import steward.league.StoredGame;
import steward.league.StoredGame.StoredSeat;
import steward.league.rating.RatingFit;

/** Games that were never played: what a large league is like. */
public final class MadeUpGames {

    /** Games in a transaction. */
    private static final int TOGETHER = 10_000;
    /** Between neighbours in strength; less in a large field. */
    private static final double STEP_ELO = 30;
    private static final double MOST_ELO = 1200;
    private static final double DRAWS = 0.05;
    private static final int TURNS = 150;
    private static final int NANOS = 2_000_000;

    private final GameStore store;
    private final int season;
    private final Season key;
    private final List<GameStore.Version> versions;
    private final SplittableRandom random;
    /** Places in the list of the two that meet, by seat. */
    private int one;
    private int other;

    /** @param versions from the strongest */
    MadeUpGames(GameStore store, int season, Season key, List<GameStore.Version> versions,
                       SplittableRandom random) {
        this.store = store;
        this.season = season;
        this.key = key;
        this.versions = versions;
        this.random = random;
    }

    /** Fills a league that has no games, between bots {@code bot-1}, {@code bot-2} and so on. */
    public static void fill(LeagueFolder folder, int games, int bots) {
        LeagueSettings settings = folder.read();
        Season season = Season.of(LeagueOpening.setup(folder, settings), settings);
        try (GameStore store = GameStore.write(folder)) {
            new MadeUpGames(store, store.open(season), season, bots(store, bots), new SplittableRandom(1)).add(games);
        }
    }

    /** A bot without a program. */
    static GameStore.Version bot(GameStore store, int number) {
        return store.add("bot-" + number, "none", null, false, String.format("%032x", number), 0);
    }

    /** So many bots without programs, from the strongest. */
    static List<GameStore.Version> bots(GameStore store, int count) {
        return IntStream.rangeClosed(1, count).mapToObj(number -> bot(store, number)).toList();
    }

    /** Stores games and those of their decisions that are not there. @return how many games are new */
    static int add(GameStore store, int season, List<StoredGame> games) {
        Map<Integer, Decision> made = new LinkedHashMap<>();
        for (StoredGame game : games) {
            boolean isMade = game.decision() < 0 || store.database().value("SELECT 1 FROM decision WHERE season = ? "
                + "AND number = ?", season, game.decision()) != null;
            if (!isMade) {
                made.merge(game.decision(), decision(game), (one, other) -> new Decision(one.number(), one.seed(),
                    Stream.concat(one.group().stream(), other.group().stream()).distinct().sorted().toList(),
                    List.of()));
            }
        }
        return store.add(season, List.of(new Decision.News(List.copyOf(made.values()), Map.of())), games);
    }

    private static Decision decision(StoredGame game) {
        return new Decision(game.decision(), game.seed(), Arrays.stream(game.lineup()).sorted().boxed().toList(),
            List.of());
    }

    /** A schedule that goes on from what is stored. */
    static Schedule schedule(GameQueries queries, List<Integer> roster) {
        Schedule schedule = new Schedule(Seeds.from(0), 2, LeagueSettings.USUAL_LAG, roster,
            new PausedBots(0, LeagueSettings.USUAL_LAG, 0), version -> { });
        queries.tell(schedule);
        return schedule;
    }

    /** Adds so many games: any two meet on one seed from both sides, as the schedule of a league has it. */
    void add(int games) {
        List<StoredGame> batch = new ArrayList<>(TOGETHER);
        List<Decision> decisions = new ArrayList<>(TOGETHER);
        for (int k = 0; k < games; k++) {
            StoredGame game = game(k);
            if (k % 2 == 0) {
                decisions.add(decision(game));
            }
            batch.add(game);
            if (batch.size() == TOGETHER || k + 1 == games) {
                store.add(season, List.of(new Decision.News(decisions, Map.of())), batch);
                batch.clear();
                decisions.clear();
            }
        }
    }

    private StoredGame game(int number) {
        if (number % 2 == 0) {
            one = random.nextInt(versions.size());
            other = (one + 1 + random.nextInt(versions.size() - 1)) % versions.size();
        } else {
            int swapped = one;
            one = other;
            other = swapped;
        }
        int decision = number / 2;
        double step = Math.min(STEP_ELO, MOST_ELO / versions.size());
        double chance = 1 / (1 + StrictMath.exp((one - other) * step / RatingFit.ELO));
        boolean draw = random.nextDouble() < DRAWS;
        boolean win = random.nextDouble() < chance;
        byte[] name = GameName.of(key, decision, List.of(versions.get(one).identity(),
            versions.get(other).identity()), 1);
        return new StoredGame(0, name, decision, decision, 1, true, TURNS, null, number, "made up", null, 0,
            List.of(seat(one, draw || win), seat(other, draw || !win)));
    }

    private StoredSeat seat(int bot, boolean first) {
        long mean = random.nextLong(NANOS);
        return new StoredSeat(versions.get(bot).id(), first ? 0 : 1, first ? 1 : 0, null, TURNS, mean,
            mean + random.nextLong(NANOS), NANOS);
    }
}
