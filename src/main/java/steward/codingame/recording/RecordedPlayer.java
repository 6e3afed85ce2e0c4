package steward.codingame.recording;

import java.nio.charset.StandardCharsets;
import java.util.List;
import steward.bot.Answer;
import steward.bot.Player;

/** A player that gives the recorded answers of a player, in CodinGame's protocol. */
final class RecordedPlayer implements Player {

    private final String name;
    private final List<List<String>> turns;
    private final Idle idle;
    private int turn;

    /** The answer of a player that was not asked any more: one without effect. */
    interface Idle {

        /** @param frame what our referee has sent */
        List<String> lines(String frame, int answerLines);
    }

    /** @param turns its lines in every turn, possibly none or too few; null where it was not asked any more */
    RecordedPlayer(String name, List<List<String>> turns, Idle idle) {
        this.name = name;
        this.turns = turns;
        this.idle = idle;
    }

    @Override
    public String name() {
        return name;
    }

    @Override
    public Ending ask(byte[] frame, int length, int answerLines, long limitNanos, Answer answer) {
        answer.clear();
        List<String> said = turn < turns.size() ? turns.get(turn) : List.of();
        turn++;
        if (said != null && said.size() < answerLines) {
            answer.setFault(said.isEmpty() ? "no answer in the recording"
                : "answered " + said.size() + " of " + answerLines + " lines in the recording");
            return Ending.FAULT;
        }
        List<String> lines = said == null ? idle.lines(new String(frame, 0, length, StandardCharsets.UTF_8),
            answerLines)
            : said.subList(0, answerLines);
        byte[] bytes = String.join("\n", lines).getBytes(StandardCharsets.UTF_8);
        answer.append(bytes, 0, bytes.length);
        return Ending.ANSWERED;
    }
}
