package steward.replay;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.function.UnaryOperator;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Alters the lines of a replay of format 3, and computes their hashes again, as a forger would. */
public final class Forge {

    private static final Pattern HASH = Pattern.compile("(?<=,\"(?:header|turn|result)Hash\":\")[0-9a-f]{16}");

    private final List<String> lines;

    private Forge(List<String> lines) {
        this.lines = new ArrayList<>(lines);
    }

    public static Forge of(Recorded replay) {
        return new Forge(replay.lines());
    }

    /** A copy of a line with the hash of what stands before it. */
    public static String rehash(String line) {
        Matcher hash = HASH.matcher(line);
        if (!hash.find()) {
            return line;
        }
        String before = line.substring(0, line.lastIndexOf(",\"", hash.start() - 1));
        byte[] bytes = before.getBytes(StandardCharsets.UTF_8);
        return line.substring(0, hash.start()) + InputHash.of(bytes, 0, bytes.length)
            + line.substring(hash.end());
    }

    /** Alters a line, counted from 0, or from the end with negative numbers; its hash stays. */
    public Forge edit(int number, UnaryOperator<String> change) {
        int at = number < 0 ? lines.size() + number : number;
        String line = change.apply(lines.get(at));
        if (line.equals(lines.get(at))) {
            throw new IllegalArgumentException("nothing was changed in " + line);
        }
        lines.set(at, line);
        return this;
    }

    /** Alters the first place where an expression matches, and makes the hash right. */
    public Forge forge(int number, String regex, String with) {
        return edit(number, line -> rehash(line.replaceFirst(regex, with)));
    }

    /** Alters the first place where an expression matches; the hash stays. */
    public Forge replace(int number, String regex, String with) {
        return edit(number, line -> line.replaceFirst(regex, with));
    }

    /** Alters the order of the lines, or which there are. */
    public Forge arrange(UnaryOperator<List<String>> change) {
        return new Forge(change.apply(new ArrayList<>(lines)));
    }

    public String text() {
        return String.join("\n", lines) + "\n";
    }
}
