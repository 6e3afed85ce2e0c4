package steward.codingame;

import java.io.ByteArrayOutputStream;
import steward.bot.Answer;
import steward.bot.Player;

/**
 * A player whose bot belongs to a tool: {@code ###Input i} and lines for it, then {@code ###Output i n} for n lines of
 * it. The tool waits for them as long as they take, so a deadline is checked once they are there.
 */
final class OldRefereePlayer implements Player {

    private static final double NANOS_PER_MS = 1e6;

    private final OldReferee referee;
    private final OldRefereeLines lines;
    private final int number;
    private final ByteArrayOutputStream told = new ByteArrayOutputStream();

    OldRefereePlayer(OldReferee referee, OldRefereeLines lines, int number) {
        this.referee = referee;
        this.lines = lines;
        this.number = number;
    }

    @Override
    public String name() {
        return "player " + number;
    }

    @Override
    public void tell(byte[] frame, int length) {
        told.write(frame, 0, length);
    }

    /** @throws OldReferee.InputEnded if the input had ended before: then this player has not failed */
    @Override
    public Ending ask(byte[] frame, int length, int answerLines, long limitNanos, Answer answer) {
        answer.clear();
        if (lines.ended()) {
            throw referee.breakOff();
        }
        lines.write("###Input " + number + "\n");
        lines.write(told.toByteArray(), told.size());
        told.reset();
        lines.write(frame, length);
        lines.write("###Output " + number + " " + answerLines + "\n");
        lines.flush();
        long start = System.nanoTime();
        String fault = read(answerLines, answer);
        answer.setNanos(System.nanoTime() - start);
        if (fault == null && answer.nanos() > limitNanos) {
            fault = "answered after " + ms(answer.nanos()) + " ms, expected at most " + ms(limitNanos);
        }
        answer.setFault(fault);
        return fault == null ? Ending.ANSWERED : Ending.FAULT;
    }

    private String read(int answerLines, Answer answer) {
        for (int k = 0; k < answerLines; k++) {
            byte[] line = lines.read();
            if (line == null) {
                return "the input ended: " + k + " of " + answerLines + " lines came";
            }
            if (lines.tooLong()) {
                return "line longer than " + OldRefereeLines.LONGEST + " bytes";
            }
            if (k > 0) {
                answer.append(new byte[] {'\n'}, 0, 1);
            }
            answer.append(line, 0, line.length);
        }
        return null;
    }

    private static double ms(long nanos) {
        return Math.round(nanos / NANOS_PER_MS * 10) / 10.0;
    }

    /** The tool ends its bots itself; the text protocol has no last lines. Without any, this player has failed. */
    @Override
    public void finish(byte[] frame, int length) {
        if (frame == null) {
            referee.failed(number);
        }
    }
}
