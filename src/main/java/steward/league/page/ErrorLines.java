package steward.league.page;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.BiPredicate;
import java.util.stream.Collectors;
import steward.contest.Failure;
import steward.contest.RecordedFailures;
import steward.game.GameTypes;
import steward.league.StoredGame;

/** Lines of stderr that explain failures of bots, read from kept replays. Each replay is read once. */
public final class ErrorLines {

    /** Games of which lines are kept; a page lists fewer. */
    private static final int MOST = 10_000;

    private final Path folder;
    private final GameTypes types;
    private final BiPredicate<StoredGame, Integer> stderr;
    private final Map<Long, Map<Integer, String>> known = new LinkedHashMap<>() {
        @Override
        protected boolean removeEldestEntry(Map.Entry<Long, Map<Integer, String>> eldest) {
            return size() > MOST;
        }
    };

    /**
     * @param folder of the replays
     * @param types  games of the replays; {@code null} for no lines
     * @param stderr whether what the bot of a seat wrote there may be seen; {@code null} for all
     */
    public ErrorLines(Path folder, GameTypes types, BiPredicate<StoredGame, Integer> stderr) {
        this.folder = folder;
        this.types = types;
        this.stderr = stderr;
    }

    /** Returns the line of the bot in a seat, see {@link Failure#error()}; {@code null} if none is known. */
    String of(StoredGame game, int seat) {
        if (types == null || game.replay() == null || game.seats().get(seat).fault() == null
            || stderr != null && !stderr.test(game, seat)) {
            return null;
        }
        Path replay = folder.resolve(game.replay());
        Map<Integer, String> lines = known.computeIfAbsent(game.id(), id -> !Files.isRegularFile(replay) ? null
            : RecordedFailures.of(types, replay).stream().filter(each -> !each.error().isEmpty())
                .collect(Collectors.toMap(Failure::player, Failure::error, (first, later) -> first)));
        return lines == null ? null : lines.get(seat);
    }
}
