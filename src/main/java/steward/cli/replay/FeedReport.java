package steward.cli.replay;

import java.io.PrintStream;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import steward.cli.shared.ExitStatus;
import steward.cli.shared.MatchReport;
import steward.cli.streams.Colour;
import steward.cli.streams.Json;
import steward.cli.streams.StandardFiles;
import steward.match.MatchResult;
import steward.replay.ReplayHeader;
import steward.replay.feed.FedTurn;
import steward.replay.feed.Takeover;
import steward.replay.verify.ReplayDifference;
import steward.report.Fields;
import steward.text.TextFormat;

/** Report, turn by turn, on whether a bot answers as recorded, with a count of the differences. */
final class FeedReport {

    /** A turn can differ in every field; more are only counted. */
    private static final int MOST_FIELDS = 6;
    private static final int MOST_TURNS = 10;
    private static final String SAME = "same";
    private static final String DIFFERS = "differs:";
    private static final int WIDTH = 100;
    private static final String INDENT = " ".repeat(11);

    private final FeedSession session;
    private final PrintStream text;
    private final Colour colour;
    private final List<FedTurn> differing = new ArrayList<>();
    private int compared;
    private int played;
    private boolean diverged;
    private boolean ended;

    FeedReport(FeedSession session) {
        this.session = session;
        text = session.text();
        colour = session.colour();
    }

    /** A turn has been answered. */
    void add(FedTurn turn) {
        String what = turn.same() ? SAME : DIFFERS + " " + differences(turn);
        if (turn.replaced()) {
            played++;
            what = diverged ? "played" + (turn.fault() == null ? "" : ": " + turn.fault()) : "played, " + what;
            diverged |= !turn.same();
        } else {
            compared++;
            if (!turn.same()) {
                differing.add(turn);
            }
        }
        if (!session.json() && (!session.quiet() || !turn.same() && !turn.replaced())) {
            text.println("turn " + TextFormat.right(Integer.toString(turn.number()), 4) + "  "
                + painted(TextFormat.wrap(TextFormat.plain(what), "; ", WIDTH - INDENT.length(), INDENT)));
            text.flush();
        }
    }

    private String painted(String what) {
        return what.equals(SAME) ? colour.good(what) : what.replaceFirst(DIFFERS, colour.bad(DIFFERS));
    }

    private static String differences(FedTurn turn) {
        if (turn.fault() != null) {
            return "recorded " + (turn.recordedFault() == null ? "a command" : turn.recordedFault()) + ", now "
                + turn.fault();
        }
        if (turn.recordedFault() != null) {
            return "recorded " + turn.recordedFault() + ", now a command";
        }
        List<String> fields = new ArrayList<>();
        for (ReplayDifference each : turn.differences()) {
            if (fields.size() == MOST_FIELDS) {
                fields.add("and " + (turn.differences().size() - MOST_FIELDS) + " more");
                break;
            }
            fields.add(each.field() + " recorded " + TextFormat.shorten(each.recorded(), WIDTH) + ", now "
                + TextFormat.shorten(each.found(), WIDTH));
        }
        return String.join("; ", fields);
    }

    /**
     * The counts of all turns that were compared, and the result of letting the bot play; said once.
     *
     * @param outcome or {@code null} if it did not play
     * @param file    of the new replay as it was typed, or {@code null}
     */
    void end(Takeover.Outcome outcome, String file) {
        if (ended) {
            return;
        }
        ended = true;
        session.streams().warn(session.match().warning());
        if (session.json()) {
            Json.print(session.streams(), fields(outcome, file));
            return;
        }
        String where = "";
        for (int k = 0; k < differing.size() && k < MOST_TURNS; k++) {
            where += (k > 0 ? ", " : differing.size() > 1 ? " (turns " : " (turn ") + differing.get(k).number();
        }
        where += differing.isEmpty() ? "" : differing.size() > MOST_TURNS ? ", ...)" : ")";
        String different = differing.size() + " different" + where;
        text.println(colour.strong(TextFormat.count(compared, "turn") + " compared:") + " "
            + (compared - differing.size()) + " the same, "
            + (differing.isEmpty() ? different : colour.bad(different)));
        if (outcome != null) {
            printOutcome(outcome, file);
        }
    }

    private void printOutcome(Takeover.Outcome outcome, String file) {
        text.println(TextFormat.count(played, "turn") + " played by the bot");
        MatchResult result = outcome.result();
        ReplayHeader header = session.match().header();
        String scene = ReplayHeaderText.scene(header);
        if (result != null) {
            text.println(colour.strong(MatchReport.headline(scene, header.seed(), result)));
        } else {
            text.println(TextFormat.plain("no result after " + TextFormat.count(outcome.turns(), "turn") + ": "
                + outcome.reason() + "; ahead then: " + String.join(", ", outcome.ahead())));
        }
        if (!StandardFiles.is(file)) {
            MatchReport.printReplay(text, Path.of(file), header.game());
        }
    }

    private Fields fields(Takeover.Outcome outcome, String file) {
        return Fields.of("player", session.player(), "name", session.match().header().names().get(session.player()),
            "bot", session.bot(), "protocol", session.protocol().word(), "compared", compared,
            "same", compared - differing.size(), "differing", Fields.each(differing, turn -> Fields.of(
                "turn", turn.number(), "recordedFault", turn.recordedFault(), "fault", turn.fault(),
                "fields", Fields.each(turn.differences(), difference -> Fields.of("field", difference.field(),
                    "recorded", difference.recorded(), "now", difference.found())))),
            "played", outcome == null ? null : Fields.of("turns", played, "turnsInAll", outcome.turns(),
                "ending", outcome.result() == null ? null : outcome.result().ending(),
                "noResultBecause", outcome.reason(), "ahead", outcome.ahead(), "replay", file));
    }

    int status() {
        return differing.isEmpty() ? ExitStatus.DONE : ExitStatus.FAILED;
    }
}
