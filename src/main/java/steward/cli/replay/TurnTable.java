package steward.cli.replay;

import java.io.PrintStream;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import steward.cli.shared.Games;
import steward.cli.shared.MatchReport;
import steward.cli.streams.Json;
import steward.cli.streams.Streams;
import steward.contest.RecordedFailures;
import steward.guest.GuestType;
import steward.match.MatchResult;
import steward.match.OwnLimits;
import steward.replay.RecordedTurn;
import steward.replay.ReplayHeader;
import steward.replay.ReplayReader;
import steward.scene.Time;
import steward.text.TextFormat;

/**
 * Table of a recorded match, turn by turn: a row per body, or the answers if there are no bodies. The events of the
 * turn follow, and the result at the end. The columns are the scalars that the game records of a body.
 */
final class TurnTable {

    private static final int WIDTH = 100;
    private static final int DECIMALS = 3;
    private static final int COLUMN = 7;
    private static final int MARGIN = 6;

    private final Streams streams;
    private final PrintStream out;
    private final ReplayReader replay;
    private final RecordedFailures failures;
    private final List<String> columns = new ArrayList<>();
    private final List<String> leftOut = new ArrayList<>();
    private long impacts;
    private boolean opened;

    /** @param replay just opened, with a header */
    TurnTable(Streams streams, ReplayReader replay) {
        this.streams = streams;
        this.out = streams.out();
        this.replay = replay;
        failures = new RecordedFailures(Games.types(), replay);
    }

    /**
     * @param from    first turn; 0 is the start
     * @param to      last turn
     * @param summary whether to leave out the turns
     */
    void print(int from, int to, boolean summary) {
        Map<String, Object> start = Json.object(replay.start());
        if (!summary) {
            chooseColumns(start);
            if (from == 0) {
                rows(0, start);
            }
        }
        int last = 0;
        for (RecordedTurn turn = replay.next(); turn != null && !streams.outEnded(); turn = replay.next()) {
            last = turn.number();
            failures.add(turn);
            Map<String, Object> outcome = Json.object(turn.outcome());
            int count = Json.objects(outcome.get("impacts")).size();
            impacts += outcome.containsKey("impactsInAll") ? (long) Json.number(outcome.get("impactsInAll")) : count;
            if (!summary && last >= from && last <= to) {
                rows(last, outcome);
                notes(turn, outcome, count);
            }
        }
        if (last < from) {
            throw TurnDetail.noSuchTurn(replay, from, last);
        }
        close(last);
    }

    private String scene() {
        return ReplayHeaderText.scene(replay.header());
    }

    /** Before the first row or the result; not at all if there is no such turn. */
    private void open() {
        if (opened) {
            return;
        }
        opened = true;
        ReplayHeader header = replay.header();
        out.println(scene() + " (" + ReplayHeaderText.game(header) + "), seed " + header.seed()
            + timeFactor(header.timeFactor()));
        for (int player = 0; player < header.names().size(); player++) {
            out.println("player " + player + "  " + ReplayHeaderText.name(header, player) + "  "
                + ReplayHeaderText.bot(header, player) + limits(header.limits().get(player)));
        }
        out.println();
        if (!columns.isEmpty()) {
            out.println(head());
        }
    }

    private static String limits(Time own) {
        return own == null ? "" : ", " + OwnLimits.of(own);
    }

    private static String timeFactor(double factor) {
        return factor == 1 ? "" : factor == Double.POSITIVE_INFINITY ? ", no deadlines"
            : ", time limits times " + TextFormat.number(factor, DECIMALS);
    }

    private void chooseColumns(Map<String, Object> start) {
        int used = "turn  body".length();
        for (Map<?, ?> body : bodies(start)) {
            for (Object key : body.keySet()) {
                String name = (String) key;
                boolean scalar = !(body.get(name) instanceof List) && !(body.get(name) instanceof Map);
                if (scalar && !name.equals("id") && !columns.contains(name) && !leftOut.contains(name)) {
                    used += width(name) + 1;
                    (used <= WIDTH ? columns : leftOut).add(name);
                }
            }
        }
    }

    private static int width(String column) {
        return Math.max(COLUMN, HeadingText.title(column).length());
    }

    private static String cell(Map<?, ?> body, String column) {
        return HeadingText.is(column) ? HeadingText.of(body.get(column), 1) : Json.word(body.get(column), DECIMALS);
    }

    private String head() {
        return "turn  body" + columns.stream().map(column -> " "
            + TextFormat.right(HeadingText.title(column), width(column))).collect(Collectors.joining());
    }

    private static List<Map<?, ?>> bodies(Map<String, Object> outcome) {
        return outcome.get("state") instanceof Map<?, ?> state ? Json.objects(state.get("bodies")) : List.of();
    }

    private void rows(int turn, Map<String, Object> outcome) {
        open();
        for (Map<?, ?> body : bodies(outcome)) {
            StringBuilder line = new StringBuilder(TextFormat.right(Integer.toString(turn), 4));
            line.append(TextFormat.right(Json.word(body.get("id"), 0), 6));
            for (String column : columns) {
                line.append(' ').append(TextFormat.right(cell(body, column), width(column)));
            }
            out.println(line);
        }
    }

    private void notes(RecordedTurn turn, Map<String, Object> outcome, int count) {
        List<String> notes = new ArrayList<>();
        if (count > 0) {
            notes.add(TextFormat.count(count, "impact"));
        }
        Json.objects(outcome.get("events")).forEach(event -> notes.add(TurnDetail.event(event)));
        String margin = " ".repeat(MARGIN);
        if (bodies(outcome).isEmpty()) {
            margin = TextFormat.right(Integer.toString(turn.number()), MARGIN - 2) + "  ";
            answers(turn, margin);
        }
        if (!notes.isEmpty()) {
            out.println(TextFormat.plain(margin + String.join("; ", notes)));
        }
        for (int player = 0; player < turn.faults().length; player++) {
            if (turn.faults()[player] != null) {
                out.println(margin + ReplayHeaderText.name(replay.header(), player) + " failed: "
                    + TextFormat.plain(turn.faults()[player]));
            }
        }
    }

    private void answers(RecordedTurn turn, String margin) {
        List<Object> commands = Json.array(turn.commands());
        for (int player = 0; player < commands.size(); player++) {
            if (commands.get(player) instanceof Map<?, ?> command && command.get("lines") instanceof List<?> lines) {
                out.println(TextFormat.plain(margin + ReplayHeaderText.name(replay.header(), player) + ": "
                    + TextFormat.shorten(TurnDetail.spell(lines), WIDTH)));
            }
        }
    }

    private void close(int turns) {
        open();
        if (!columns.isEmpty()) {
            out.println();
        }
        if (!leftOut.isEmpty()) {
            out.println("left out, see --turn: " + String.join(", ", leftOut));
        }
        MatchResult result = RecordedResult.of(replay, ReplayHeaderText.names(replay.header()));
        if (result == null) {
            out.println(turns == 0 ? "no turn was recorded" : "no result after " + TextFormat.count(turns, "turn"));
        } else {
            MatchReport.print(out, streams.outColour(), scene(), replay.header().seed(), result, failures.failures());
        }
        if (!replay.header().game().equals(GuestType.ID)) {
            out.println(TextFormat.count(impacts, "impact") + " in all");
        }
    }
}
