package steward.bot;

import java.util.function.Consumer;
import java.util.function.IntFunction;

/** Another player that writes to stderr as well. */
public final class StderrPlayer implements Player {

    private final Player player;
    private final IntFunction<String> stderr;
    private int turn;

    /** @param stderr what it writes there in the turns it is asked, counted from 1 */
    public StderrPlayer(Player player, IntFunction<String> stderr) {
        this.player = player;
        this.stderr = stderr;
    }

    @Override
    public String name() {
        return player.name();
    }

    @Override
    public void tell(byte[] lines, int length) {
        player.tell(lines, length);
    }

    @Override
    public Ending ask(byte[] frame, int length, int answerLines, long limitNanos, Answer answer) {
        Ending ending = player.ask(frame, length, answerLines, limitNanos, answer);
        answer.setStderr(stderr.apply(++turn));
        return ending;
    }

    @Override
    public void onAbandoned(Consumer<Answer> continuation) {
        player.onAbandoned(continuation);
    }

    @Override
    public void finish(byte[] lines, int length) {
        player.finish(lines, length);
    }
}
