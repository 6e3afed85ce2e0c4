package steward.replay.verify;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import steward.bot.LineBuffer;
import steward.game.JsonNumbers;
import steward.numerics.StateHash;
import steward.replay.InputHash;
import steward.replay.OutcomeJson;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.ObjectWriteContext;

/**
 * Checks the line of a turn by writing it again: only its commands are read, the turn is played, and the bytes that we
 * would write are compared with those that are there. A line that has anything unusual (a fault, a message, other
 * blanks, a difference) is left to who takes it apart and can say what it is.
 *
 * <pre>
 * {"type":"turn","turn":7,"commands":[...],"inputHash":"0123456789abcdef","outcome":{...},
 *  "times":{"answerNanos":[1,2]}}                                                 (in one line)
 * </pre>
 */
final class TurnCheck {

    private static final byte[] BEFORE_NUMBER = bytes("{\"type\":\"turn\",\"turn\":");
    private static final byte[] BEFORE_COMMANDS = bytes(",\"commands\":");
    private static final byte[] BEFORE_HASH = bytes(",\"inputHash\":\"");
    private static final byte[] BEFORE_OUTCOME = bytes("\",\"outcome\":");
    private static final byte[] BEFORE_TIMES = bytes(",\"times\":{\"answerNanos\":[");
    private static final byte[] NULL = bytes("null");
    private static final byte[] END = bytes("]}}");
    private static final int HASH_DIGITS = 16;
    private static final int KINDS_OF_TEXTS = 3;
    private static final int MOST_DIGITS = 18;

    private final Resimulation again;
    private final int format;
    private final LineBuffer outcome = new LineBuffer();
    private final JsonGenerator out = JsonNumbers.FACTORY.createGenerator(ObjectWriteContext.empty(), outcome);
    private final OutcomeJson json = new OutcomeJson();
    private final StateHash hash = new StateHash();

    /** What came of looking at a line. */
    enum Found {
        /** The turn was played, and agrees in every byte. */
        SAME,
        /** The turn was played as the line says; something behind its commands is unusual or differs. */
        PLAYED,
        /** Nothing was done. */
        NOTHING
    }

    /** @param format of the replay */
    TurnCheck(Resimulation again, int format) {
        this.again = again;
        this.format = format;
    }

    private static byte[] bytes(String text) {
        return text.getBytes(StandardCharsets.UTF_8);
    }

    /** Checks the line of the turn that comes next. */
    Found check(byte[] line) {
        int number = again.game().turn() + 1;
        int at = skip(line, skipNumber(line, skip(line, 0, BEFORE_NUMBER), number), BEFORE_COMMANDS);
        if (at < 0 || again.game().isOver()) {
            return Found.NOTHING;
        }
        int rest = again.readCommands(line, at, line.length);
        if (rest < 0) {
            return Found.NOTHING;
        }
        int end = line.length - rest;
        int digits = skip(line, end, BEFORE_HASH);
        int from = digits < 0 ? -1 : skip(line, digits + HASH_DIGITS, BEFORE_OUTCOME);
        if (from < 0 || !isHash(line, digits, inputHash(line, at, end))) {
            return Found.NOTHING;
        }
        again.game().play();
        byte[] written = outcome();
        int to = from + outcome.size();
        boolean same = to <= line.length && Arrays.equals(line, from, to, written, 0, outcome.size());
        return same && areTimes(line, skip(line, to, BEFORE_TIMES)) ? Found.SAME : Found.PLAYED;
    }

    /** Writes the outcome of the turn last played; the bytes count up to {@link #outcomeLength}. */
    byte[] outcome() {
        outcome.reset();
        json.write(out, again.game(), again.codec());
        out.flush();
        return outcome.bytes();
    }

    int outcomeLength() {
        return outcome.size();
    }

    /** As {@link InputHash}, of commands alone: nobody failed, said or wrote anything. */
    private long inputHash(byte[] line, int from, int to) {
        InputHash.add(hash.reset(), format, line, from, to);
        for (int none = KINDS_OF_TEXTS * again.game().players(); none > 0; none--) {
            InputHash.add(hash, null);
        }
        return hash.value();
    }

    private static boolean isHash(byte[] line, int from, long hash) {
        for (int k = 0; k < HASH_DIGITS; k++) {
            if (line[from + k] != Character.forDigit((int) (hash >>> 4 * (HASH_DIGITS - 1 - k)) & 0xF, 16)) {
                return false;
            }
        }
        return true;
    }

    /** Where the line goes on behind a text, or -1 if that is not there; -1 also for -1. */
    private static int skip(byte[] line, int from, byte[] text) {
        int to = from + text.length;
        return from >= 0 && to <= line.length && Arrays.equals(line, from, to, text, 0, text.length) ? to : -1;
    }

    private static int skipNumber(byte[] line, int from, int number) {
        int value = 0;
        int at = from;
        while (at >= 0 && at < line.length && isDigit(line[at]) && value <= number) {
            value = 10 * value + line[at++] - '0';
        }
        return at > from && line[from] != '0' && value == number ? at : -1;
    }

    private static boolean isDigit(byte one) {
        return one >= '0' && one <= '9';
    }

    /** Whether numbers and nulls follow, with commas between, and then the end of the line. */
    private static boolean areTimes(byte[] line, int from) {
        int at = from;
        while (at >= 0) {
            at = skipTime(line, at);
            if (at >= 0 && at < line.length && line[at] == ',') {
                at++;
            } else {
                return skip(line, at, END) == line.length;
            }
        }
        return false;
    }

    private static int skipTime(byte[] line, int from) {
        if (from < line.length && line[from] == NULL[0]) {
            return skip(line, from, NULL);
        }
        int at = from;
        while (at < line.length && isDigit(line[at])) {
            at++;
        }
        boolean plain = at > from && at - from <= MOST_DIGITS && (line[from] != '0' || at == from + 1);
        return plain ? at : -1;
    }
}
