package steward.bot;

import java.util.ArrayList;
import java.util.List;
import java.util.function.UnaryOperator;

/** Bot that plays like another, but for some answers, and keeps what it is sent. */
public final class AlteredBot implements Bot {

    /** Change of an answer. */
    public interface Change {
        /** @param turn counted from the first that is asked */
        String of(int turn, String answer);
    }

    private final Bot like;
    private final Change change;
    private final List<String> sent = new ArrayList<>();
    private int asked;

    /** A bot that changes every answer. */
    public AlteredBot(Bot like, Change change) {
        this.like = like;
        this.change = change;
    }

    /** A bot that changes the answer of one turn; of none if it is 0. */
    public AlteredBot(Bot like, int turn, UnaryOperator<String> change) {
        this(like, (asked, answer) -> asked == turn ? change.apply(answer) : answer);
    }

    /** Lines that it was sent: setup, turns and end. */
    public List<String> sent() {
        return sent;
    }

    @Override
    public void setup(String line) {
        sent.add(line);
        like.setup(line);
    }

    @Override
    public String turn(String line) {
        sent.add(line);
        return change.of(++asked, like.turn(line));
    }

    @Override
    public void end(String line) {
        sent.add(line);
        like.end(line);
    }
}
