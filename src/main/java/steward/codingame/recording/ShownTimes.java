package steward.codingame.recording;

import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;

/**
 * Times of answers as views of a referee show them. A recording does not tell them, but some referees show them, and
 * engines that ask for them put a player out by them. Two plays in which every answer was given with another time tell
 * the places where a view shows one, and whose it is; there the recorded view has the true one.
 */
final class ShownTimes {

    private static final Pattern PART = Pattern.compile("\\d+|\\D+");
    private static final int MOST_DIGITS = 6;
    /** Different times in a row that answers are given with in the second play. */
    private static final int PROBES = 37;
    /** Late answers of which the last one puts a player out. */
    private static final int LATE_ANSWERS = 3;

    private ShownTimes() { }

    /**
     * Reads times in the recorded views, up to the first one that differs in anything else.
     *
     * @param plain    lines of the views of the first play, with the given times
     * @param probed   likewise of the second one
     * @param recorded likewise of the recording; {@code null} for a frame that has none
     * @param told     times of the first play, by the number of the frame that has the answer; those that are shown
     *                 are put in
     * @param probes   likewise of the second one
     * @return the number of the frame that differs in anything else; -1 if there is none
     */
    static int read(List<String> plain, List<String> probed, List<String> recorded, int[] told, int[] probes) {
        int frames = Math.max(plain.size(), recorded.size());
        int[] before = told.clone();
        for (int frame = 0; frame < frames; frame++) {
            if (frame >= plain.size() || frame >= recorded.size()) {
                return frame;
            }
            if (recorded.get(frame) != null && !read(frame, frame < probed.size() ? probed.get(frame)
                    : plain.get(frame), plain.get(frame), recorded.get(frame), before, told, probes)) {
                return frame;
            }
        }
        return -1;
    }

    private static boolean read(int frame, String probed, String plain, String recorded, int[] before, int[] told,
                                int... probes) {
        if (plain.equals(recorded) && plain.equals(probed)) {
            return true;
        }
        String[] ours = parts(plain);
        String[] others = parts(probed);
        String[] theirs = parts(recorded);
        if (ours.length != theirs.length || ours.length != others.length) {
            return false;
        }
        for (int part = 0; part < ours.length; part++) {
            int of = ours[part].equals(others[part]) ? -1 : answer(frame, ours[part], others[part], before, probes);
            if (of >= 0 && theirs[part].matches("\\d{1," + MOST_DIGITS + "}")) {
                told[of] = Integer.parseInt(theirs[part]);
            } else if (!ours[part].equals(theirs[part])) {
                return false;
            }
        }
        return true;
    }

    /** The latest answer that both plays show so; -1 if there is none. */
    private static int answer(int frame, String ours, String other, int[] before, int... probes) {
        for (int of = Math.min(frame, before.length - 1); of >= 0; of--) {
            if (ours.equals(Integer.toString(before[of])) && other.equals(Integer.toString(probes[of]))) {
                return of;
            }
        }
        return -1;
    }

    private static String[] parts(String text) {
        return PART.matcher(text).results().map(MatchResult::group).toArray(String[]::new);
    }

    /**
     * Supposes that a player was late for the last time that is allowed: its last answers get such times, as many as
     * it lacks.
     *
     * @param answers numbers of the frames that have answers of the player, in order
     * @param lateMs  after which each answer is late, by the number of its frame
     * @return whether that changes a time
     */
    static boolean supposeLate(List<Integer> answers, int[] told, int... lateMs) {
        int missing = LATE_ANSWERS - (int) answers.stream().filter(frame -> told[frame] > lateMs[frame]).count();
        boolean changed = false;
        for (int k = answers.size() - 1; k >= 0 && missing > 0; k--) {
            int frame = answers.get(k);
            if (told[frame] <= lateMs[frame]) {
                told[frame] = lateMs[frame] + 1;
                changed = true;
                missing--;
            }
        }
        return changed;
    }

    /** Times of the second play: others than those of the first, and late where those are. */
    static int[] probes(int[] told, int... lateMs) {
        int[] probes = new int[told.length];
        for (int frame = 0; frame < told.length; frame++) {
            probes[frame] = told[frame] > lateMs[frame] ? told[frame] + 1 : 1 + frame % PROBES;
            probes[frame] += probes[frame] == told[frame] ? 1 : 0;
        }
        return probes;
    }
}
