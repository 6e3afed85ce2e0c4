package steward.cli.play;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import steward.codingame.GameResultLog;
import steward.files.InputException;
import steward.replay.ReplayHeader;

/**
 * Existing files that an arena tool's call may replace. They are empty files, which tools make beforehand, and files
 * that an earlier call has written, since tools use the same names again. Other files are kept.
 */
final class RefereeFiles {

    static final String REPLAY = ".jsonl";
    private static final String PAGE = ".html";

    /** How every page begins. */
    private static final String PAGE_SIGNATURE = "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n"
        + "<meta charset=\"utf-8\">\n<meta http-equiv=\"Content-Security-Policy\"";

    static Path pageOf(Path replay) {
        String name = replay.getFileName().toString();
        String base = name.endsWith(REPLAY) ? name.substring(0, name.length() - REPLAY.length()) : name;
        return replay.resolveSibling(base + PAGE);
    }

    /**
     * Checks everything that is about to be written; opens nothing for writing.
     *
     * @param log    or {@code null}
     * @param replay or {@code null}
     * @param page   whether there is to be one beside the replay
     * @throws InputException if a file is of another kind
     */
    static void check(Path log, Path replay, boolean page) {
        if (isThere(log) && !GameResultLog.isIn(log)) {
            throw kept("-l ", log, "a game result");
        }
        checkReplay("-r ", replay);
        Path beside = page && replay != null ? pageOf(replay) : null;
        if (isThere(beside) && !begins(beside, PAGE_SIGNATURE)) {
            throw kept("-s: ", beside, "a page of a match");
        }
    }

    /**
     * Checks a replay that is about to be written.
     *
     * @param option which names it, with a blank
     * @param replay or {@code null}
     * @throws InputException if it is of another kind
     */
    static void checkReplay(String option, Path replay) {
        if (isThere(replay) && !begins(replay, ReplayHeader.SIGNATURE)) {
            throw kept(option, replay, "a replay");
        }
    }

    /** True if there is a file with something in it; a device such as {@code /dev/null} holds nothing. */
    private static boolean isThere(Path file) {
        try {
            return file != null && Files.isRegularFile(file) && Files.size(file) > 0;
        } catch (IOException problem) {
            throw unreadable(file, problem);
        }
    }

    private static boolean begins(Path file, String signature) {
        byte[] wanted = signature.getBytes(StandardCharsets.UTF_8);
        try (InputStream in = Files.newInputStream(file)) {
            return Arrays.equals(wanted, in.readNBytes(wanted.length));
        } catch (IOException problem) {
            throw unreadable(file, problem);
        }
    }

    private static InputException kept(String option, Path file, String kind) {
        return new InputException(option + file + ": found a file of another kind, which is kept; expected a new or "
            + "empty file, or " + kind + " to be replaced");
    }

    private static InputException unreadable(Path file, IOException problem) {
        return new InputException(file + ": exists, but cannot be read to see what would be replaced: "
            + problem.getMessage());
    }
}
