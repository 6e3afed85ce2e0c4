package steward.bot;

import java.util.function.IntFunction;
import java.util.function.UnaryOperator;

/** Bots that a test can write in one line. */
public final class TestBots {

    private TestBots() {
    }

    /** Answers what follows from the frame of the turn alone. */
    public static Bot answering(UnaryOperator<String> answer) {
        return new Bot() {
            @Override
            public void setup(String line) {
                // Nothing follows from it.
            }

            @Override
            public String turn(String line) {
                return answer.apply(line);
            }
        };
    }

    /** Answers by the number of the turn, counted from 1, whatever it is sent. */
    public static Bot byTurn(IntFunction<String> answer) {
        int[] turns = new int[1];
        return answering(line -> answer.apply(++turns[0]));
    }
}
