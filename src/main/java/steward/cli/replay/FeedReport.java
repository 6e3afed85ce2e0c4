package steward.cli.replay;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import steward.cli.shared.ExitStatus;
import steward.cli.shared.Json;
import steward.cli.shared.MatchText;
import steward.cli.shared.Streams;
import steward.match.MatchResult;
import steward.replay.RecordedMatch;
import steward.replay.feed.FedTurn;
import steward.replay.feed.Takeover;
import steward.replay.verify.Difference;
import steward.text.TextFormat;

/** Tells, turn by turn, whether a bot does what was recorded, and counts. */
final class FeedReport {

    /** A turn can differ in every field; more are only counted. */
    private static final int MOST_FIELDS = 6;
    private static final int MOST_TURNS = 10;
    private static final int WIDTH = 100;
    private static final String INDENT = " ".repeat(11);

    private final Streams streams;
    private final RecordedMatch match;
    private final boolean quiet;
    private final List<Integer> differing = new ArrayList<>();
    private int compared;
    private int played;
    private boolean diverged;

    FeedReport(Streams streams, RecordedMatch match, boolean quiet) {
        this.streams = streams;
        this.match = match;
        this.quiet = quiet;
    }

    /** A turn has been answered. */
    void add(FedTurn turn) {
        String what = turn.same() ? "same" : "differs: " + differences(turn);
        if (turn.replaced()) {
            played++;
            what = diverged ? "played" + (turn.fault() == null ? "" : ": " + turn.fault()) : "played, " + what;
            diverged |= !turn.same();
        } else {
            compared++;
            if (!turn.same()) {
                differing.add(turn.number());
            }
        }
        if (!quiet || !turn.same() && !turn.replaced()) {
            streams.out().println("turn " + TextFormat.right(Integer.toString(turn.number()), 4) + "  "
                + TextFormat.wrap(TextFormat.plain(what), "; ", WIDTH - INDENT.length(), INDENT));
            streams.out().flush();
        }
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
        for (Difference each : turn.differences()) {
            if (fields.size() == MOST_FIELDS) {
                fields.add("and " + (turn.differences().size() - MOST_FIELDS) + " more");
                break;
            }
            fields.add(each.field() + " recorded " + TextFormat.shorten(each.recorded(), WIDTH) + ", now "
                + TextFormat.shorten(each.found(), WIDTH));
        }
        return String.join("; ", fields);
    }

    /** The counts of all turns that were compared. */
    void sum() {
        String where = "";
        for (int k = 0; k < differing.size() && k < MOST_TURNS; k++) {
            where += (k > 0 ? ", " : differing.size() > 1 ? " (turns " : " (turn ") + differing.get(k);
        }
        where += differing.isEmpty() ? "" : differing.size() > MOST_TURNS ? ", ...)" : ")";
        streams.out().println(TextFormat.count(compared, "turn") + " compared: " + (compared - differing.size())
            + " the same, " + differing.size() + " different" + where);
        if (match.warning() != null) {
            streams.warn(match.warning());
        }
    }

    /** What came of letting the bot play. */
    void outcome(Takeover.Outcome outcome, Path file) {
        streams.out().println(TextFormat.count(played, "turn") + " played by the bot");
        MatchResult result = outcome.result();
        String scene = Json.word(Json.object(match.header().scene()).get("name"), 0);
        if (result != null) {
            streams.out().println(MatchText.headline(scene, match.header().seed(), result));
        } else {
            streams.out().println(TextFormat.plain("no result after " + TextFormat.count(outcome.turns(), "turn") + ": "
                + outcome.reason() + "; ahead then: " + FeedSession.names(match, outcome.ahead())));
        }
        MatchText.printReplay(streams.out(), file);
    }

    int status() {
        return differing.isEmpty() ? ExitStatus.DONE : ExitStatus.FAILED;
    }
}
