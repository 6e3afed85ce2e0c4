package steward.cli.league.view;

import java.io.PrintStream;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import steward.cli.shared.FailureReason;
import steward.cli.shared.Games;
import steward.contest.Failure;
import steward.contest.RecordedFailures;
import steward.league.StoredGame;
import steward.text.TextFormat;

/** Failures of bots in games of a league: details from each game's replay, and counts of each kind. */
public final class GameFailures {

    private static final int MOST = 10;

    private final Path replays;
    private final Map<List<Object>, Kind> kinds = new LinkedHashMap<>();

    private static final class Kind {
        private int games;
        private StoredGame example;
        private String reason;
        private int player;
    }

    /** @param replays the folder of kept replays */
    public GameFailures(Path replays) {
        this.replays = replays;
    }

    /** Adds a game; the first one of a kind is its example. */
    public void add(StoredGame game) {
        game.seats().forEach(seat -> add(game, seat.version()));
    }

    /** Adds the failure of one version in a game, if it failed. */
    public void add(StoredGame game, int version) {
        for (int player = 0; player < game.seats().size(); player++) {
            StoredGame.StoredSeat seat = game.seats().get(player);
            if (seat.version() == version && seat.fault() != null) {
                Kind kind = kinds.computeIfAbsent(List.of(seat.version(), Failure.kind(seat.fault())),
                    key -> new Kind());
                kind.games++;
                kind.example = kind.games == 1 ? game : kind.example;
                kind.reason = kind.games == 1 ? seat.fault() : kind.reason;
                kind.player = kind.games == 1 ? player : kind.player;
            }
        }
    }

    /** One line for each bot and kind, the most frequent first; with what its stderr says, where a replay is kept. */
    public List<String> lines(Map<Integer, String> names) {
        List<String> lines = new ArrayList<>();
        kinds.entrySet().stream().sorted(Comparator.comparingInt((Map.Entry<?, Kind> each) -> -each.getValue().games))
            .limit(MOST).forEach(each -> lines.add(TextFormat.plain(names.get((Integer) each.getKey().get(0))
                + " failed in " + TextFormat.count(each.getValue().games, "game") + ", such as game "
                + each.getValue().example.id() + ": " + each.getValue().reason + said(each.getValue()))));
        if (kinds.size() > MOST) {
            lines.add("and in " + TextFormat.count(kinds.size() - MOST, "other way"));
        }
        return lines;
    }

    private String said(Kind kind) {
        return RecordedFailures.of(Games.types(), replay(replays, kind.example)).stream()
            .filter(each -> each.player() == kind.player).findFirst().map(FailureReason::said).orElse("");
    }

    /** The file of a game's replay, or {@code null}. */
    static Path replay(Path replays, StoredGame game) {
        return game.replay() == null ? null : replays.resolve(game.replay());
    }

    /** Everything about the failures of a game. */
    static void print(PrintStream out, StoredGame game, Path replay, Map<Integer, String> names) {
        for (Failure failure : RecordedFailures.of(Games.types(), replay)) {
            out.println(TextFormat.plain("         " + names.get(game.seats().get(failure.player()).version())
                + " failed in turn " + failure.turn() + ": " + failure.reason()));
            FailureReason.print(out, failure, "           ");
        }
    }
}
