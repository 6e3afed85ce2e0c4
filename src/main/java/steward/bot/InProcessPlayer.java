package steward.bot;

import java.nio.charset.StandardCharsets;
import steward.Internal;

/**
 * Player whose {@link Bot} runs on the asking thread, for tests and trusted bots. Time is measured as for a bot program
 * and the limit applies, but a bot that never returns cannot be stopped.
 *
 * <p>Lines sent before a turn are one call of {@link Bot#setup}; the turn itself is one call of {@link Bot#turn}. A
 * frame of several lines arrives as one text, without the last line end. The answer must have the requested number of
 * lines, each at most 64 KiB long.
 */
public class InProcessPlayer implements Player {

    private final String name;
    private final Bot bot;
    private final LineBuffer told = new LineBuffer();
    private boolean over;

    /** A player called {@code name} whose answers come from {@code bot}. */
    public InProcessPlayer(String name, Bot bot) {
        this.name = name;
        this.bot = bot;
    }

    @Override
    public final String name() {
        return name;
    }

    @Override
    public void tell(byte[] lines, int length) {
        told.write(lines, 0, length);
    }

    @Override
    public final Ending ask(byte[] frame, int length, int answerLines, long limitNanos, Answer answer) {
        answer.clear();
        if (over) {
            return fault(answer, "asked again after its end");
        }
        long limit = Math.max(1, limitNanos);
        long start = System.nanoTime();
        String problem;
        try {
            problem = played(frame, length, answerLines, answer);
        } catch (Throwable thrown) {
            // Anything a bot throws, errors included, is the bot's failure and not the referee's.
            answer.setNanos(System.nanoTime() - start);
            return fault(answer, "threw " + thrown);
        }
        answer.setNanos(System.nanoTime() - start);
        if (answer.nanos() > limit) {
            problem = FaultMessages.late(limit, answer.nanos());
        }
        return problem == null ? Ending.ANSWERED : fault(answer, problem);
    }

    /** Lets the bot answer, within its time. @return what is wrong, or {@code null} */
    @Internal
    protected String played(byte[] frame, int length, int answerLines, Answer answer) {
        if (told.size() > 0) {
            bot.setup(text(told.bytes(), told.size()));
            told.reset();
        }
        String said = bot.turn(text(frame, length));
        return said == null ? "answered null" : take(said, answerLines, answer);
    }

    /** Puts the answer's lines, without carriage returns at their ends, into {@code answer}; returns what is wrong. */
    private static String take(String said, int expected, Answer answer) {
        byte[] bytes = said.getBytes(StandardCharsets.UTF_8);
        int end = bytes.length > 0 && bytes[bytes.length - 1] == '\n' ? bytes.length - 1 : bytes.length;
        int lines = 0;
        for (int from = 0; from <= end; lines++) {
            int to = from;
            while (to < end && bytes[to] != '\n') {
                to++;
            }
            int count = to > from && bytes[to - 1] == '\r' ? to - from - 1 : to - from;
            if (count > AnswerReader.LINE_LIMIT) {
                return FaultMessages.tooLong(AnswerReader.LINE_LIMIT);
            }
            answer.append(bytes, from, count);
            if (to < end) {
                answer.append(bytes, to, 1);
            }
            from = to + 1;
        }
        if (lines < expected) {
            return "answered " + lines + " of " + expected + " lines";
        }
        return lines == expected ? null : "answered " + lines + " lines instead of " + expected;
    }

    private Ending fault(Answer answer, String reason) {
        over = true;
        answer.setFault(reason);
        return Ending.FAULT;
    }

    private static String text(byte[] bytes, int length) {
        int count = length > 0 && bytes[length - 1] == '\n' ? length - 1 : length;
        return new String(bytes, 0, count, StandardCharsets.UTF_8);
    }

    @Override
    public final void finish(byte[] lines, int length) {
        boolean polite = !over && lines != null;
        over = true;
        try {
            if (polite) {
                end(lines, length);
            }
        } catch (Throwable thrown) {
            // The match is over; an exception of the bot no longer matters.
            return;
        }
    }

    /** Tells the bot that the match is over. */
    @Internal
    protected void end(byte[] lines, int length) {
        bot.end(text(lines, length));
    }
}
