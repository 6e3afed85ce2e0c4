package steward.codingame;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import steward.bot.Answer;
import steward.bot.Player;

/** A player that gives the recorded answers of a player, in CodinGame's protocol. */
final class RecordedPlayer implements Player {

    private final GameRecording recording;
    private final int number;
    private int turn;

    RecordedPlayer(GameRecording recording, int number) {
        this.recording = recording;
        this.number = number;
    }

    @Override
    public String name() {
        return "player " + number;
    }

    @Override
    public void tell(byte[] lines, int length) {
        // The answers are recorded, so the lines are not needed.
    }

    @Override
    public Ending ask(byte[] frame, int length, int answerLines, long limitNanos, Answer answer) {
        answer.clear();
        List<String> said = turn < recording.turns().size() ? recording.turns().get(turn).commands().get(number)
            : List.of();
        turn++;
        if (said != null && said.size() < answerLines) {
            answer.setFault(said.isEmpty() ? "no answer in the recording"
                : "answered " + said.size() + " of " + answerLines + " lines in the recording");
            return Ending.FAULT;
        }
        List<String> lines = said == null ? idle(frame, length, answerLines) : said.subList(0, answerLines);
        byte[] bytes = String.join("\n", lines).getBytes(StandardCharsets.UTF_8);
        answer.append(bytes, 0, bytes.length);
        return Ending.ANSWERED;
    }

    /** The answer where none is recorded: every pod aims at its own position, which has no effect. */
    private static List<String> idle(byte[] frame, int length, int pods) {
        List<String> lines = new ArrayList<>();
        for (String line : new String(frame, 0, length, StandardCharsets.UTF_8).split("\n")) {
            String[] words = line.split(" ");
            if (lines.size() < pods) {
                lines.add(words[0] + " " + words[1] + " 0 not asked any more");
            }
        }
        return lines;
    }

    @Override
    public void onAbandoned(Consumer<Answer> continuation) {
        // A call always returns.
    }

    @Override
    public void finish(byte[] lines, int length) {
        // Nothing to end.
    }
}
