package steward.match;

import java.util.regex.Matcher;
import java.util.regex.Pattern;
import steward.scene.Time;

/**
 * Time limits in milliseconds for one bot that replace the scene's.
 *
 * @param answerMs      for every answer but the first, 1 to {@link #MOST_MS}
 * @param firstAnswerMs for the first answer, its start included, up to {@link #MOST_MS}; 0 for the scene's, but no less
 *                      than for the others
 */
public record OwnLimits(int answerMs, int firstAnswerMs) {

    /** Longest limit: an hour, as in scenes. */
    public static final int MOST_MS = 3_600_000;
    /** Form of limits as they are written. */
    public static final String FORM = "MS[,FIRST]";
    /** Name of the field with limits as they are written, in everything for programs. */
    public static final String FIELD = "timeLimit";
    /** Form of limits in words. */
    public static final String EXPECTED = "whole numbers of milliseconds from 1 to " + MOST_MS + " as " + FORM;

    private static final Pattern WRITTEN = Pattern.compile("(\\d{1,9})(?:,(\\d{1,9}))?");

    public OwnLimits {
        if (answerMs < 1 || answerMs > MOST_MS || firstAnswerMs < 0 || firstAnswerMs > MOST_MS) {
            throw new IllegalArgumentException("found limits of " + answerMs + " and " + firstAnswerMs
                + " ms, expected " + EXPECTED);
        }
    }

    /** Returns both limits of a player as own ones; {@code null} for {@code null}, those of the scene. */
    public static OwnLimits of(Time time) {
        return time == null ? null : new OwnLimits(time.answerMs(), time.firstAnswerMs());
    }

    /**
     * Reads {@code MS[,FIRST]}.
     *
     * @throws IllegalArgumentException if it is written otherwise
     */
    public static OwnLimits parse(String text) {
        Matcher written = WRITTEN.matcher(text);
        int answer = written.matches() ? Integer.parseInt(written.group(1)) : 0;
        int first = answer == 0 || written.group(2) == null ? 0 : Integer.parseInt(written.group(2));
        if (answer < 1 || answer > MOST_MS || first > MOST_MS || first == 0 && text.indexOf(',') >= 0) {
            throw new IllegalArgumentException("found '" + text + "', expected " + EXPECTED);
        }
        return new OwnLimits(answer, first);
    }

    /** Returns them as {@link #parse} reads them. */
    public String written() {
        return answerMs + (firstAnswerMs == 0 ? "" : "," + firstAnswerMs);
    }

    /** Returns limits as {@link #parse} reads them; {@code null} for {@code null}, those of the scene. */
    public static String writtenOrNull(OwnLimits limits) {
        return limits == null ? null : limits.written();
    }

    /** Returns both limits in a scene. */
    public Time in(Time scene) {
        return new Time(firstAnswerMs == 0 ? Math.max(scene.firstAnswerMs(), answerMs) : firstAnswerMs, answerMs);
    }

    /** {@code answers within 60 ms, the first within 500 ms}. */
    @Override
    public String toString() {
        return "answers within " + answerMs + " ms"
            + (firstAnswerMs == 0 ? "" : ", the first within " + firstAnswerMs + " ms");
    }
}
