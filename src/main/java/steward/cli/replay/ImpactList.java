package steward.cli.replay;

import java.io.PrintStream;
import java.util.List;
import java.util.Map;
import steward.cli.streams.Json;
import steward.cli.streams.Streams;
import steward.replay.RecordedTurn;
import steward.replay.ReplayReader;
import steward.text.TextFormat;

/** List of recorded impacts, printed one a line. */
final class ImpactList {

    /** The impacts of a range of turns, both ends included. */
    static void print(Streams streams, ReplayReader replay, int from, int to) {
        PrintStream out = streams.out();
        int last = 0;
        int count = 0;
        out.println("turn  " + HEAD);
        for (RecordedTurn turn = replay.next(); turn != null && turn.number() <= to && !streams.outEnded();
             turn = replay.next()) {
            last = turn.number();
            if (last >= from) {
                Map<String, Object> outcome = Json.object(turn.outcome());
                for (Map<?, ?> impact : Json.objects(outcome.get("impacts"))) {
                    out.println(TextFormat.right(Integer.toString(last), 4) + "  " + line(impact));
                    count++;
                }
                if (outcome.containsKey("impactsInAll")) {
                    out.println("      of " + Json.word(outcome.get("impactsInAll"), 0) + ": the rest is not recorded");
                }
            }
        }
        if (last < from) {
            throw TurnDetail.noSuchTurn(replay, from, last);
        }
        out.println(TextFormat.count(count, "impact"));
    }

    /** The header of {@link #line}. */
    static final String HEAD = "    time     a       b      a at x,    y      b at x,    y    impulse       energy";

    /** One impact; where b is a wall, its place is the point that was hit. */
    static String line(Map<?, ?> impact) {
        boolean wall = impact.containsKey("wall");
        String b = wall ? "wall " + Json.word(impact.get("wall"), 0) : Json.word(impact.get("b"), 0);
        StringBuilder line = new StringBuilder();
        line.append(TextFormat.fixed(Json.number(impact.get("time")), 6))
            .append(TextFormat.right(Json.word(impact.get("a"), 0), 6))
            .append(TextFormat.right(b, 8));
        for (String name : List.of("ax", "ay", "bx", "by")) {
            line.append(TextFormat.right(TextFormat.fixed(Json.number(impact.get(name)), 1), name.endsWith("x") ? 11
                : 9));
        }
        line.append(TextFormat.right(TextFormat.fixed(Json.number(impact.get("impulse")), 2), 10))
            .append(TextFormat.right(TextFormat.fixed(Json.number(impact.get("energy")), 0), 13));
        return line.toString();
    }
}
