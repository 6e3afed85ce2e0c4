package steward.replay.verify;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/**
 * Scanner that finds the parts of an ordinary turn line by their bytes, without parsing: a turn without faults,
 * messages and stderr.
 *
 * <pre>
 * {"type":"turn","turn":7,"commands":[...],"outcome":{...},"turnHash":"0123456789abcdef",
 *  "times":{"answerNanos":[1,2]}}                                                 (in one line)
 * </pre>
 *
 * <p>Every method returns -1 for a missing part, also if {@code from} is -1.
 */
final class LineScanner {

    private static final byte[] BEFORE_NUMBER = bytes("{\"type\":\"turn\",\"turn\":");
    private static final byte[] BEFORE_COMMANDS = bytes(",\"commands\":");
    private static final byte[] BEFORE_OUTCOME = bytes(",\"outcome\":");
    private static final byte[] BEFORE_HASH = bytes(",\"turnHash\":\"");
    private static final byte[] BEFORE_TIMES = bytes(",\"times\":{");
    private static final byte[] BEFORE_NANOS = bytes("\"answerNanos\":[");
    private static final byte[] NULL = bytes("null");
    private static final byte[] END = bytes("]}}");
    private static final int MOST_DIGITS = 18;

    private static byte[] bytes(String text) {
        return text.getBytes(StandardCharsets.UTF_8);
    }

    /** Returns where the commands of a turn begin. */
    static int commands(byte[] line, int number) {
        return skip(line, skipNumber(line, skip(line, 0, BEFORE_NUMBER), number), BEFORE_COMMANDS);
    }

    /** Returns where the outcome begins, if its field name begins at {@code from}. */
    static int outcome(byte[] line, int from) {
        return skip(line, from, BEFORE_OUTCOME);
    }

    /** Returns where the digits of the hash begin, if its field name begins at {@code from}. */
    static int hash(byte[] line, int from) {
        return skip(line, from, BEFORE_HASH);
    }

    /** True if a line ends as it is written: with its brace, perhaps {@code times} before it, whatever is in them. */
    static boolean isEnd(byte[] line, int from) {
        int times = skip(line, from, BEFORE_TIMES);
        return times >= 0 ? line.length >= times + 2 && line[line.length - 1] == '}' && line[line.length - 2] == '}'
            : from == line.length - 1 && line[from] == '}';
    }

    /** True if the times of the players follow, numbers and nulls with commas between, and then the end of the line. */
    static boolean isTimes(byte[] line, int from) {
        int at = skip(line, skip(line, from, BEFORE_TIMES), BEFORE_NANOS);
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
