package steward.cli.shared;

import java.io.BufferedInputStream;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import steward.files.InputException;
import steward.replay.ReplayReader;
import steward.scene.SceneFiles;
import steward.scene.SceneText;

/** The word {@code -} where a file is expected: the standard input, or the standard output. */
public final class StandardFiles {

    /** What the standard input is called in errors. */
    public static final String INPUT = "standard input";

    private static final String DASH = "-";

    private StandardFiles() {
    }

    /** Whether a file as it was typed is one of the standard streams; {@code null} is not. */
    public static boolean is(String typed) {
        return DASH.equals(typed);
    }

    /** All of the standard input; buffered, because {@link java.io.FileInputStream#readAllBytes} fails on pipes. */
    public static byte[] readAll(Streams streams) {
        try {
            return new BufferedInputStream(streams.in()).readAllBytes();
        } catch (IOException problem) {
            throw unreadable(problem);
        }
    }

    /** A replay that comes on the standard input. */
    public static ReplayReader openReplay(Streams streams) {
        return openReplay(readAll(streams));
    }

    /** A replay that came on the standard input. */
    public static ReplayReader openReplay(byte[] replay) {
        return new ReplayReader(new ByteArrayInputStream(replay), INPUT);
    }

    /** A scene that comes on the standard input. */
    static SceneText readScene(Streams streams) {
        try {
            return SceneFiles.read(new BufferedInputStream(streams.in()), INPUT);
        } catch (IOException problem) {
            throw unreadable(problem);
        }
    }

    /** The refusal of a standard input that cannot be read, such as a folder. */
    public static InputException unreadable(IOException problem) {
        String message = String.valueOf(problem.getMessage());
        return new InputException(INPUT + ": found "
            + (message.contains("directory") ? "a folder" : "nothing that can be read (" + message + ")")
            + ", expected a file or a pipe");
    }
}
