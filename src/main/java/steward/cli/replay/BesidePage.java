package steward.cli.replay;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.function.Function;
import steward.cli.shared.FailedException;
import steward.cli.shared.Pages;
import steward.cli.streams.Streams;
import steward.files.InputException;
import steward.files.OutputFiles;
import steward.game.GameTypes;
import steward.replay.RecordedTurn;
import steward.replay.ReplayHeader;
import steward.replay.ReplayReader;
import steward.replay.page.PageTemplate;
import steward.replay.page.ReplayPage;
import steward.report.Fields;
import steward.text.TextFormat;

/** Page of two replays of one scene, seed and players, side by side, with one clock and their differences. */
final class BesidePage {

    private static final String FOLDER = "/steward/beside/";
    private static final int SHOWN = 60;

    private final List<Path> files;
    private final List<ReplayHeader> headers;
    private final int[] turns = new int[2];
    private int firstDifferent = -1;
    /** Both results, where both replays have one and they differ; otherwise none. */
    private List<String> results = List.of();

    /** Reads both. @throws InputException if they are not of one scene, seed and players */
    BesidePage(Streams streams, Path one, Path other) {
        files = List.of(one, other);
        try (ReplayReader a = ReplayCommand.open(one); ReplayReader b = ReplayCommand.open(other)) {
            headers = Arrays.asList(a.header(), b.header());
            for (int k = 0; k < 2; k++) {
                if (headers.get(k) == null) {
                    throw new InputException(files.get(k) + ": found a replay that was cut off in its header");
                }
            }
            requireSame("game", ReplayHeader::game);
            requireSame("scene", ReplayHeader::scene);
            requireSame("seed", ReplayHeader::seed);
            requireSame("players", ReplayHeader::names);
            RecordedTurn[] next = {a.next(), b.next()};
            while (next[0] != null || next[1] != null) {
                if (next[0] != null && next[1] != null && firstDifferent < 0 && differ(next[0], next[1])) {
                    firstDifferent = next[0].number();
                }
                for (int k = 0; k < 2; k++) {
                    turns[k] += next[k] == null ? 0 : 1;
                    next[k] = next[k] == null ? null : (k == 0 ? a : b).next();
                }
            }
            if (a.resultJson() != null && b.resultJson() != null && !result(a).equals(result(b))) {
                results = List.of(result(a), result(b));
            }
            for (ReplayReader each : List.of(a, b)) {
                streams.warn(each.warning());
            }
        }
    }

    /** Ending and standing as the result line has them, without names and times. */
    private static String result(ReplayReader replay) {
        String line = new String(replay.resultJson(), StandardCharsets.UTF_8);
        int from = line.indexOf("\"ending\"");
        int to = line.indexOf(",\"players\"");
        return from < 0 || to < from ? line : line.substring(from, to);
    }

    private void requireSame(String what, Function<ReplayHeader, Object> field) {
        Object one = field.apply(headers.get(0));
        Object other = field.apply(headers.get(1));
        if (!Objects.equals(one, other)) {
            String found = "--beside: found " + (what.equals("players") ? "other " : "another ") + what + " in "
                + files.get(1) + ": ";
            throw new InputException(found + (what.equals("scene") ? sceneDifference(one.toString(), other.toString())
                : shown(other) + ", expected " + shown(one) + " as in " + files.get(0)));
        }
    }

    private static String shown(Object value) {
        return TextFormat.beginning(TextFormat.plain(String.valueOf(value)), SHOWN);
    }

    /** The places from which on two texts differ. */
    private static String sceneDifference(String one, String other) {
        int at = Arrays.mismatch(one.toCharArray(), other.toCharArray());
        int from = Math.max(0, one.lastIndexOf('"', Math.max(0, at - 1)) - SHOWN / 2);
        return shown(other.substring(Math.min(from, other.length()))) + ", expected "
            + shown(one.substring(Math.min(from, one.length())));
    }

    private static boolean differ(RecordedTurn one, RecordedTurn other) {
        return !Arrays.equals(one.commands(), other.commands()) || !Arrays.equals(one.outcome(), other.outcome())
            || !Arrays.equals(one.faults(), other.faults());
    }

    /** Says in a sentence where the matches part. */
    String summary() {
        String ends = turns[0] == turns[1] ? "" : "; " + files.get(turns[0] < turns[1] ? 0 : 1) + " ends after turn "
            + Math.min(turns[0], turns[1]);
        return (firstDifferent < 0 ? "No turn of both differs" : "The first turn that differs: " + firstDifferent)
            + ends + (results.isEmpty() ? "" : "; the results differ");
    }

    /** Writes the page. */
    void write(Path page, boolean overwrite, GameTypes types) {
        for (Path file : files) {
            if (OutputFiles.isSame(page, file)) {
                throw new InputException("--view: found a replay itself, expected another file");
            }
        }
        try {
            ReplayPage.Shell shell = ReplayPage.shell();
            List<ReplayPage.Embedded> replays = List.of(ReplayPage.embedded(files.get(0), types, null),
                ReplayPage.embedded(files.get(1), types, null));
            byte[] html = PageTemplate.of(FOLDER, Pages.title(headers.get(0).names()), shell, Fields.of("files",
                Fields.each(files, Path::getFileName), "first", firstDifferent, "results", results,
                "shell", List.of(shell.before(), shell.after()),
                "replays", Fields.each(replays, ReplayPage.Embedded::replay),
                "details", Fields.each(replays, ReplayPage.Embedded::details)));
            Pages.write(page, html, overwrite);
        } catch (IOException problem) {
            throw new FailedException(page + ": cannot be written: " + problem.getMessage());
        }
    }
}
