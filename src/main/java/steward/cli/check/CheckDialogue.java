package steward.cli.check;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import steward.bot.Answer;
import steward.bot.Player;
import steward.bot.TimeBasis;

/** Dialogue that keeps a copy of the lines sent and answered: all of the first turns and of the last ones. */
public final class CheckDialogue implements Player {

    private static final int FIRST = 20;
    private static final int LAST = 10;
    private static final int LONGEST = 20_000;

    private final Player player;
    private final List<Turn> first = new ArrayList<>();
    private final List<Turn> last = new ArrayList<>();
    private String told = "";
    private String sent = "";
    private int turns;

    /**
     * One question.
     *
     * @param number   counted from 1
     * @param received what the bot was sent
     * @param answer   what came; with a fault, what had come by then
     * @param stderr   what it wrote there meanwhile, or {@code null}
     * @param fault    how it failed, or {@code null}
     * @param nanos    how long it took
     */
    public record Turn(int number, String received, String answer, String stderr, String fault, long nanos) { }

    CheckDialogue(Player player) {
        this.player = player;
    }

    @Override
    public String name() {
        return player.name();
    }

    @Override
    public void limitBy(TimeBasis basis) {
        player.limitBy(basis);
    }

    @Override
    public void tell(byte[] lines, int length) {
        told = text(lines, length);
        player.tell(lines, length);
    }

    private static String text(byte[] lines, int length) {
        return new String(lines, 0, Math.min(length, LONGEST), StandardCharsets.UTF_8)
            + (length > LONGEST ? "... (" + length + " bytes)\n" : "");
    }

    @Override
    public Ending ask(byte[] frame, int length, int answerLines, long limitNanos, Answer answer) {
        sent = told + text(frame, length);
        told = "";
        Ending ending = player.ask(frame, length, answerLines, limitNanos, answer);
        if (ending != Ending.ABANDONED) {
            note(answer);
        }
        return ending;
    }

    private void note(Answer answer) {
        Turn turn = new Turn(++turns, sent, answer.text(), answer.stderr(), answer.fault(), answer.nanos());
        if (turns <= FIRST) {
            first.add(turn);
            return;
        }
        last.add(turn);
        if (last.size() > LAST) {
            last.remove(0);
        }
    }

    @Override
    public void onAbandoned(Consumer<Answer> continuation) {
        player.onAbandoned(answer -> {
            note(answer);
            continuation.accept(answer);
        });
    }

    @Override
    public void sendLastLines(byte[] lines, int length) {
        player.sendLastLines(lines, length);
    }

    @Override
    public void finish(byte[] lines, int length) {
        player.finish(lines, length);
    }

    @Override
    public String finalStderr() {
        return player.finalStderr();
    }

    /** The first and the last turns. */
    List<Turn> turns() {
        List<Turn> all = new ArrayList<>(first);
        all.addAll(last);
        return all;
    }
}
