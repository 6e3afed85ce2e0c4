package steward.replay.verify;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import steward.game.Game;
import steward.game.ViewWriter;
import steward.replay.RecordedTurn;
import steward.replay.ServerRecording;
import steward.text.TextFormat;

/**
 * Comparison of a server's frames, line by line and word by word, with the frames that it would have written for our
 * game. The comparison stops at the first difference, since the games differ from there on. It counts the numbers and
 * words that agree, and names the ones that are not compared.
 */
public final class ViewComparison {

    /** Greatest relative distance of a number from ours that need only be near. */
    private static final double NEAR = 1e-9;

    private static final int MOST_NEAR = 5;
    /** Characters of a line that are shown before the first that differs. */
    private static final int BEFORE = 40;
    /** Number or word of a text of which nothing else is known. */
    private static final Pattern VALUE = Pattern.compile("[^\\s,:;{}\\[\\]\"]+");
    private static final Pattern NUMBER = Pattern.compile("[-+]?[0-9]+(\\.[0-9]+)?([eE][-+]?[0-9]+)?");

    private ViewWriter writer;
    private Game game;
    private final List<String> near = new ArrayList<>();
    private int nearInAll;
    private boolean any;
    private long values;
    private int turns;
    private int missing;
    private int behind;
    /** Views that end early, and frames behind the end, of which a game does not know what they show. */
    private int cut;
    private int unknown;
    private int aside;
    private boolean isResultCompared = true;
    private ReplayDifference difference;

    /** Begins with a game that has not been played yet. @return this */
    ViewComparison of(ViewWriter itsWriter, Game ours) {
        writer = itsWriter;
        game = ours;
        writer.begin(game);
        return this;
    }

    /** Returns how many numbers and words agree. */
    public long values() {
        return values;
    }

    /** Numbers that are only within 1e-9 of ours, each by its place; the first few of them. */
    public List<String> near() {
        return near;
    }

    /** Returns how many numbers are only within 1e-9 of ours. */
    public int nearInAll() {
        return nearInAll;
    }

    /** Returns in words what the server shows and was not compared; empty if it shows nothing. */
    public List<String> notCompared() {
        if (!any) {
            return List.of();
        }
        List<String> notCompared = new ArrayList<>(writer.notCompared());
        if (missing > 0) {
            notCompared.add(TextFormat.count(missing, "text") + " of frames that the recording lacks");
        }
        if (behind > 0) {
            notCompared.add(TextFormat.count(behind, "frame") + " behind the first difference");
        }
        if (cut > 0) {
            notCompared.add("the rest of " + TextFormat.count(cut, "view") + " that "
                + (cut == 1 ? "ends" : "end") + " early");
        }
        if (unknown > 0) {
            notCompared.add(TextFormat.count(unknown, "frame") + " behind the end");
        }
        if (aside > 0) {
            notCompared.add(TextFormat.count(aside, "frame") + " of the referee that "
                + (aside == 1 ? "ends" : "end") + " no turn");
        }
        if (!isResultCompared) {
            notCompared.add("ranks and scores");
        }
        return notCompared;
    }

    /** The first difference, or {@code null}. */
    ReplayDifference difference() {
        return difference;
    }

    /** Returns in how many turns a server has shown the state, and it agrees. */
    int turns() {
        return turns;
    }

    void start(List<ServerRecording.Frame> frames) {
        if (!frames.isEmpty()) {
            ViewWriter.Frame start = writer.start();
            beforeLast(0, frames);
            compare(0, frames.get(frames.size() - 1), start, true);
        }
    }

    /** Notes how the game stands before a turn. */
    void before() {
        writer.before();
    }

    /** Compares the frames of the turn just played. */
    void turn(RecordedTurn turn, List<ServerRecording.Frame> shown) {
        List<ServerRecording.Frame> frames = compared(shown);
        if (difference != null) {
            behind += frames.size();
            return;
        }
        beforeLast(turn.number(), frames);
        int last = frames.size() - 1;
        behind += difference == null || last < 0 ? 0 : 1;
        if (last >= 0) {
            List<String> view = lines(frames.get(last).view());
            compare(turn.number(), frames.get(last),
                writer.after(turn.messages(), view == null ? List.of() : view), true);
            turns += difference == null && view != null && view.size() > 1 ? 1 : 0;
        }
    }

    /** Returns frames without those that are never compared, which it counts. */
    private List<ServerRecording.Frame> compared(List<ServerRecording.Frame> frames) {
        List<ServerRecording.Frame> compared = frames.stream().filter(frame -> !frame.aside()).toList();
        aside += frames.size() - compared.size();
        return compared;
    }

    /** Compares the frames of a turn but for its last one, and how many there are. */
    private void beforeLast(int turn, List<ServerRecording.Frame> frames) {
        for (int k = 0; k < frames.size() - 1; k++) {
            behind += difference == null ? 0 : 1;
            compare(turn, frames.get(k), writer.answer(k), false);
        }
        int ours = writer.frames();
        if (ours > 0 && ours != frames.size() && difference == null) {
            difference = new ReplayDifference(turn, "frames", Integer.toString(frames.size()), Integer.toString(ours));
        }
    }

    /** Compares the result, and what was shown behind the end. */
    void end(ServerRecording.End end) {
        if (difference == null && end.turns() != game.turn()) {
            difference = new ReplayDifference(game.turn(), "turns", Integer.toString(end.turns()),
                Integer.toString(game.turn()));
        }
        String ranks = IntStream.of(game.ranks()).mapToObj(Integer::toString).collect(Collectors.joining(" "));
        double[] scores = writer.scores() == null ? game.scores() : writer.scores();
        compareGiven("ranks", end.ranks(), ranks);
        compareGiven("scores", scores.length == 0 ? null : end.scores(), DoubleStream.of(scores)
            .mapToObj(Double::toString).collect(Collectors.joining(" ")));
        compareText(game.turn(), "input", end.input(), writer.input());
        compareText(game.turn(), "metadata", end.data(), writer.metadata());
        for (ServerRecording.Frame frame : compared(end.frames())) {
            behind += difference == null ? 0 : 1;
            List<String> declared = writer.declared();
            boolean isKnown = !declared.equals(ViewWriter.UNKNOWN);
            unknown += isKnown || difference != null ? 0 : 1;
            if (isKnown) {
                compare(game.turn(), "view", lines(frame.view()), declared, true);
            }
        }
    }

    private void compareGiven(String name, String recorded, String found) {
        isResultCompared &= recorded == null || difference == null;
        if (recorded != null) {
            compare(game.turn(), name, List.of(recorded), List.of(found), false);
        }
    }

    private void compare(int turn, ServerRecording.Frame recorded, ViewWriter.Frame found, boolean mayEnd) {
        if (found.view() != null) {
            compare(turn, "view", lines(recorded.view()), found.view(), mayEnd);
        }
        compareText(turn, "summary", recorded.summary(), found.summary());
        if (recorded.information() != null) {
            compareText(turn, "gameInformation", recorded.information(), found.information());
        }
        if (recorded.tooltips() != null) {
            compareText(turn, "tooltips", recorded.tooltips(), found.tooltips());
        }
    }

    /** Compares a text unless its lines are not known. */
    private void compareText(int turn, String name, String recorded, List<String> found) {
        if (found != null) {
            compare(turn, name, recorded == null ? null : split(recorded), found, false);
        }
    }

    /** The lines of a view; none if it is blank, {@code null} without one. */
    private List<String> lines(String view) {
        return view == null ? null : view.isBlank() ? List.of() : writer.lines(view.stripTrailing());
    }

    private static List<String> split(String text) {
        return text.isBlank() ? List.of() : List.of(text.stripTrailing().split("\r?\n", -1));
    }

    /**
     * Compares one text, if nothing has differed yet.
     *
     * @param recorded its lines, or {@code null} if it was not recorded
     * @param mayEnd   true if the text may end where the writer says so
     */
    private void compare(int turn, String name, List<String> recorded, List<String> found, boolean mayEnd) {
        if (recorded == null) {
            missing += difference != null || found.isEmpty() ? 0 : 1;
            return;
        }
        any = true;
        for (int line = 0; line < Math.max(recorded.size(), found.size()) && difference == null; line++) {
            boolean ends = line >= recorded.size() && mayEnd && writer.mayEndAt(line);
            boolean rest = line >= found.size() - 1 && !found.isEmpty() && !writer.isVerbatim()
                && found.get(found.size() - 1).equals(ViewWriter.REST);
            if (ends || rest) {
                cut += ends && !rest ? 1 : 0;
                return;
            }
            compareLine(turn, name + " line " + line, line < recorded.size() ? recorded.get(line) : null,
                line < found.size() ? found.get(line) : null);
        }
    }

    private void compareLine(int turn, String where, String recorded, String found) {
        ReplayDifference.Lines lines = new ReplayDifference.Lines(recorded == null ? "" : recorded.strip(),
            found == null ? "" : found.strip().replace(ViewWriter.NEAR, ""));
        if (recorded == null || found == null) {
            difference = new ReplayDifference(turn, where, recorded == null ? "nothing" : recorded,
                found == null ? "nothing" : lines.ours(), lines);
            return;
        }
        if (writer.isVerbatim()) {
            compareVerbatim(turn, where, recorded, found);
            return;
        }
        List<String> theirs = words(recorded);
        List<String> ours = words(found);
        boolean rest = !ours.isEmpty() && ours.get(ours.size() - 1).equals(ViewWriter.REST);
        int count = rest ? ours.size() - 1 : Math.max(theirs.size(), ours.size());
        for (int k = 0; k < count; k++) {
            String their = k < theirs.size() ? theirs.get(k) : "nothing";
            String our = k < ours.size() ? ours.get(k) : "nothing";
            if (k < theirs.size() && our.equals(ViewWriter.ANY)) {
                continue;
            }
            String place = where + ", word " + k;
            String plain = our.startsWith(ViewWriter.NEAR) ? our.substring(ViewWriter.NEAR.length()) : our;
            if (k < theirs.size() && k < ours.size() && distance(their, plain) == 0) {
                values++;
            } else if (!plain.equals(our) && distance(their, plain) <= NEAR) {
                nearInAll++;
                if (near.size() < MOST_NEAR) {
                    near.add(new ReplayDifference(turn, place, their, plain).toString());
                }
            } else {
                difference = new ReplayDifference(turn, place, their, plain, lines);
                return;
            }
        }
    }

    private void compareVerbatim(int turn, String where, String recorded, String found) {
        int at = IntStream.range(0, Math.max(recorded.length(), found.length())).filter(k -> k >= recorded.length()
            || k >= found.length() || recorded.charAt(k) != found.charAt(k)).findFirst().orElse(-1);
        if (at < 0) {
            values += Math.max(1, VALUE.matcher(found).results().count());
        } else {
            int from = Math.max(0, at - BEFORE);
            difference = new ReplayDifference(turn, where + ", character " + at, rest(recorded, at), rest(found, at),
                new ReplayDifference.Lines(rest(recorded, from), rest(found, from)));
        }
    }

    private static String rest(String line, int from) {
        return from >= line.length() ? "the end" : line.substring(from);
    }

    private static List<String> words(String line) {
        return line.isBlank() ? List.of() : Arrays.asList(line.strip().split("\\s+"));
    }

    /** Relative distance of two numbers, which different programs write in different ways; of equal words 0. */
    private static double distance(String their, String our) {
        if (their.equals(our)) {
            return 0;
        }
        if (!NUMBER.matcher(their).matches() || !NUMBER.matcher(our).matches()) {
            return Double.POSITIVE_INFINITY;
        }
        double one = Double.parseDouble(their);
        double other = Double.parseDouble(our);
        return one == other ? 0 : Math.abs(one - other) / Math.max(Math.abs(one), Math.abs(other));
    }
}
