package steward.codingame.recording;

import java.nio.charset.StandardCharsets;
import java.util.List;
import steward.bot.Answer;
import steward.bot.Player;
import steward.game.ServerView;
import steward.game.ViewWriter;

/** Player that gives the recorded answers of a player, in CodinGame's protocol. */
final class RecordedPlayer implements Player {

    private final String name;
    private final List<List<String>> turns;
    private final ServerView view;
    private int turn;

    /**
     * @param turns its lines in every turn, possibly none or too few; null where it was not asked any more
     * @param view  says what has no effect then
     */
    RecordedPlayer(String name, List<List<String>> turns, ServerView view) {
        this.name = name;
        this.turns = turns;
        this.view = view;
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
        return say(said == null ? view.idle(new String(frame, 0, length, StandardCharsets.UTF_8), answerLines) : said,
            answerLines, answer);
    }

    /** Answers with the first of the lines that were recorded; fails if there are too few. */
    static Ending say(List<String> said, int answerLines, Answer answer) {
        if (said.size() < answerLines) {
            answer.setFault(said.isEmpty() ? ViewWriter.NO_ANSWER
                : "answered " + said.size() + " of " + answerLines + " lines in the recording");
            return Ending.FAULT;
        }
        byte[] bytes = String.join("\n", said.subList(0, answerLines)).getBytes(StandardCharsets.UTF_8);
        answer.append(bytes, 0, bytes.length);
        return Ending.ANSWERED;
    }
}
