package steward.cli.replay;

import java.io.PrintStream;
import java.io.UncheckedIOException;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import steward.cli.streams.Json;
import steward.files.InputException;
import steward.game.GameTypes;
import steward.replay.RecordedTurn;
import steward.replay.ReplayException;
import steward.replay.ReplayReader;
import steward.replay.feed.Feed;
import steward.replay.feed.SentLines;
import steward.scene.json.SceneException;
import steward.text.TextFormat;

/** Printer of everything that was recorded of one turn. */
final class TurnDetail {

    private static final int WIDTH = 100;
    private static final int DECIMALS = 9;

    private final PrintStream out;
    private final ReplayReader replay;
    private SentLines frames;
    private String unknown;

    /** @param types by which the match is played again for what bots were sent */
    TurnDetail(PrintStream out, ReplayReader replay, GameTypes types) {
        this.out = out;
        this.replay = replay;
        told(() -> frames = new SentLines(replay, types));
    }

    /** @throws InputException if the replay has no such turn */
    void print(int number) {
        RecordedTurn turn = find(number);
        String[] sent = sent(turn);
        print(turn, sent);
    }

    /** @throws InputException if the replay has no such turn */
    RecordedTurn find(int number) {
        int last = 0;
        for (RecordedTurn turn = replay.next(); turn != null; turn = replay.next()) {
            last = turn.number();
            if (last == number) {
                return turn;
            }
            RecordedTurn before = turn;
            told(() -> Feed.play(frames.match(), before));
        }
        throw noSuchTurn(replay, number, last);
    }

    /** The lines that each bot was sent for the turn that was found; {@code null} for none, or where unknown. */
    String[] sent(RecordedTurn turn) {
        String[] sent = new String[replay.header().names().size()];
        told(() -> Arrays.setAll(sent, player -> frames.text(player, turn)));
        return sent;
    }

    /** A match that cannot be played again is shown as far as it is recorded. */
    private void told(Runnable work) {
        try {
            if (unknown == null) {
                work.run();
            }
        } catch (ReplayException | SceneException | UncheckedIOException problem) {
            unknown = problem.getMessage();
        }
    }

    /** The refusal of a turn that was not played. */
    static InputException noSuchTurn(ReplayReader replay, int number, int last) {
        return new InputException(replay.source() + ": found no turn " + number + (last == 0 ? ": it has none"
            : ", expected 1 to " + last) + (replay.warning() == null ? "" : " (the file was cut off)"));
    }

    private void print(RecordedTurn turn, String[] sent) {
        Map<String, Object> outcome = Json.object(turn.outcome());
        out.println("turn " + turn.number());
        players(turn, sent);
        if (unknown != null) {
            out.println();
            out.println(TextFormat.plain("what bots were sent is not known: " + unknown));
        }
        List<Map<?, ?>> events = Json.objects(outcome.get("events"));
        if (!events.isEmpty()) {
            out.println();
            out.println("events");
            for (Map<?, ?> event : events) {
                out.println("  " + event(event));
            }
        }
        List<Map<?, ?>> impacts = Json.objects(outcome.get("impacts"));
        if (!impacts.isEmpty()) {
            out.println();
            out.println("impacts");
            out.println("  " + ImpactList.HEAD);
            impacts.forEach(impact -> out.println("  " + ImpactList.line(impact)));
        }
        if (outcome.get("impactLimit") instanceof Map<?, ?> limit) {
            out.println("  the turn reached its bound on impacts at time " + Json.word(limit.get("time"), 9));
        }
        if (outcome.get("state") instanceof Map<?, ?> state) {
            out.println();
            out.println("state after the turn, in full (hash " + Json.word(outcome.get("hash"), 0) + ")");
            state(out, state);
        }
    }

    private void players(RecordedTurn turn, String[] sent) {
        List<Object> commands = Json.array(turn.commands());
        Object nanos = turn.times() == null ? null : Json.object(turn.times()).get("answerNanos");
        for (int player = 0; player < replay.header().names().size(); player++) {
            double time = nanos instanceof List<?> list && player < list.size() ? Json.number(list.get(player))
                : Double.NaN;
            out.println();
            out.println("player " + player + ", " + ReplayHeaderText.name(replay.header(), player)
                + (Double.isNaN(time) ? "" : ", " + TextFormat.fixed(time / TextFormat.NANOS_PER_MS, 2) + " ms"));
            Object command = player < commands.size() ? commands.get(player) : null;
            say(out, "sent   ", sent[player]);
            say(out, "command", command == null ? "none" : spell(command));
            say(out, "message", turn.messages()[player]);
            say(out, "stderr ", turn.stderr()[player]);
            say(out, "failed ", turn.faults()[player]);
        }
    }

    private static void say(PrintStream out, String what, String text) {
        if (text != null) {
            String indent = "\n" + " ".repeat(what.length() + 4);
            out.println("  " + what + "  " + TextFormat.plain(text).stripTrailing().replace("\n", indent));
        }
    }

    /** An event in a few words. */
    static String event(Map<?, ?> event) {
        String text = event.get("text") instanceof String words ? words : Json.word(event.get("kind"), 0);
        String body = event.containsKey("body") && !(event.get("text") instanceof String)
            ? " of body " + Json.word(event.get("body"), 0) : "";
        return TextFormat.plain(text) + body;
    }

    private static void state(PrintStream out, Map<?, ?> state) {
        state.forEach((name, value) -> {
            if (value instanceof List<?> list && !Json.objects(value).isEmpty()) {
                list.forEach(each -> out.println("  " + TextFormat.wrap(spell(each), "  ", WIDTH - 2, "    ")));
            } else {
                out.println("  " + name + " " + spell(value));
            }
        });
    }

    /** A value as readable text: fields with their names, every digit. */
    static String spell(Object value) {
        StringBuilder text = new StringBuilder();
        if (value instanceof Map<?, ?> fields) {
            fields.forEach((name, each) -> text.append(text.length() == 0 ? "" : "  ").append(HeadingText.title(name))
                .append(' ').append(HeadingText.is(name) ? HeadingText.of(each, DECIMALS) : spell(each)));
        } else if (value instanceof List<?> list) {
            boolean objects = !Json.objects(value).isEmpty();
            list.forEach(each -> text.append(text.length() == 0 ? "" : objects ? "\n" : ", ").append(spell(each)));
        } else if (value instanceof Double number && number != Math.rint(number)) {
            text.append(number.doubleValue());
        } else {
            text.append(Json.word(value, 0));
        }
        return text.toString();
    }
}
