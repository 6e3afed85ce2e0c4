package steward.contest;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Counts of failures in many games by bot and kind, each kind with its earliest game as an example. Thread-safe. */
public final class FailureCounts {

    private final Contest contest;
    private final Map<List<Object>, List<Found>> kinds = new LinkedHashMap<>();
    private int games;

    private record Found(FailureKind.Occurrence occurrence, Failure failure) { }

    /** None yet of games between the bots of a contest. */
    public FailureCounts(Contest contest) {
        this.contest = contest;
    }

    /** Adds a game; of the failures, those of the earliest game of a kind keep their lines. */
    synchronized void add(Series.Played game, List<Failure> failures) {
        for (Failure failure : failures) {
            List<Found> all = kinds.computeIfAbsent(List.of(game.entrantOf(contest, failure.player()), failure.kind()),
                kind -> new ArrayList<>());
            boolean first = all.isEmpty() || game.number() < all.get(0).occurrence().game().number();
            all.add(first ? 0 : all.size(), new Found(new FailureKind.Occurrence(game, failure.turn()),
                first ? failure : null));
        }
    }

    /**
     * Adds the games of a seed, with numbers that go on from seed to seed.
     *
     * @param count how many the seed has
     * @param found those in which a bot failed, their numbers counted from 1 within the seed
     */
    synchronized void addSeed(int count, Map<Series.Played, List<Failure>> found) {
        found.forEach((game, failures) -> add(game.numbered(games + game.number()), failures));
        games += count;
    }

    /** The kinds, that of the earliest game first. */
    public synchronized List<FailureKind> kinds() {
        List<FailureKind> list = new ArrayList<>();
        kinds.forEach((key, all) -> list.add(new FailureKind((Integer) key.get(0), all.stream().map(Found::occurrence)
            .sorted(Comparator.comparingInt(one -> one.game().number())).toList(), all.get(0).failure())));
        list.sort(Comparator.comparingInt((FailureKind kind) -> kind.game().number())
            .thenComparingInt(FailureKind::entrant));
        return list;
    }
}
