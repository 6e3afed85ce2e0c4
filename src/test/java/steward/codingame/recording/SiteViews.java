package steward.codingame.recording;

import java.util.ArrayList;
import java.util.List;
import steward.game.ViewWriter;
import steward.game.podrace.PodRace;
import steward.match.TestScenes;
import steward.physics.Impact;

/**
 * Writes the views of a race that is played here, as the site's server shows one; what is known from the server stands
 * in place of ours. Only games of the server can tell the worth of ours.
 */
final class SiteViews {

    /** Where the words of {@code x y vx vy heading shield next} stand in the line of a pod. */
    private static final int[] COLUMNS = {0, 1, 2, 3, 8, 9, 10};
    private static final int FIRST_POD_OF_START = 5;

    private final ViewWriter writer = TestScenes.TYPES.viewWriter("pod-race").orElseThrow();
    private final PodRace race;
    private List<String> summary;
    private final boolean[] failed;

    SiteViews(PodRace race) {
        this.race = race;
        failed = new boolean[race.players()];
        writer.begin(race);
    }

    /** To be called when the commands of a turn are read. */
    void before() {
        for (int player = 0; player < failed.length; player++) {
            failed[player] = !race.isIn(player);
        }
        writer.before();
    }

    /** @param pods the words of the server, as many of a pod as are known; empty for none */
    String first(List<String[]> pods) {
        ViewWriter.Frame frame = writer.start();
        summary = frame.summary();
        List<String> lines = new ArrayList<>(frame.view());
        lines.set(0, " 0");
        replace(lines, FIRST_POD_OF_START, pods);
        return String.join("\n", lines) + "\n";
    }

    /** Up to the counters. @param message of every pod */
    String after(int frame, List<String[]> pods, String message) {
        ViewWriter.Frame ours = writer.after(new String[race.players()], List.of());
        summary = ours.summary().stream().map(line -> line.equals(ViewWriter.REST) ? "End reached" : line).toList();
        int pastCounters = 2 + 2 * race.settings().pods();
        List<String> lines = new ArrayList<>(ours.view().subList(0, pastCounters));
        lines.set(0, lines.get(0).replaceFirst("^\\*", " " + frame).stripTrailing());
        replace(lines, 1, pods);
        for (int pod = 0; pod < race.settings().pods(); pod++) {
            lines.set(2 + 2 * pod, "\"" + (failed[race.playerOf(pod)] ? "" : message) + "\"");
        }
        return String.join("\n", lines) + "\n";
    }

    /** Summary that goes with the view last written. */
    String summary() {
        return String.join("\n", summary) + "\n";
    }

    String impacts() {
        StringBuilder lines = new StringBuilder();
        for (int k = 0; k < race.log().impacts(); k++) {
            Impact impact = race.log().impact(k);
            lines.append(k).append(' ').append(impact.time()).append(' ').append(impact.a()).append(' ')
                .append(Math.round(impact.ax())).append(' ').append(Math.round(impact.ay())).append(' ')
                .append(impact.b()).append(' ').append(Math.round(impact.bx())).append(' ')
                .append(Math.round(impact.by())).append(' ').append(impact.impulse()).append(' ')
                .append(Math.round((impact.vaxBefore() + impact.vbxBefore()) / 2)).append(' ')
                .append(Math.round((impact.vayBefore() + impact.vbyBefore()) / 2)).append('\n');
        }
        return lines.toString();
    }

    double[] scores() {
        return writer.scores();
    }

    private static void replace(List<String> lines, int first, List<String[]> pods) {
        for (int pod = 0; pod < pods.size(); pod++) {
            String[] words = lines.get(first + 2 * pod).split(" ");
            for (int k = 0; k < pods.get(pod).length; k++) {
                if (pods.get(pod)[k] != null) {
                    words[COLUMNS[k]] = pods.get(pod)[k];
                }
            }
            lines.set(first + 2 * pod, String.join(" ", words));
        }
    }
}
