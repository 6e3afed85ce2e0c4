package steward.cli.streams;

import java.io.BufferedInputStream;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import steward.files.InputException;
import steward.replay.ReplayReader;
import steward.scene.SceneFiles;
import steward.scene.SceneText;

/** Meaning of the word {@code -} in place of a file: the standard input, or the standard output. */
public final class StandardFiles {

    /** Name of the standard input in errors. */
    public static final String INPUT = "standard input";

    private static final String DASH = "-";

    private StandardFiles() { }

    /** True if a file as it was typed is one of the standard streams; {@code null} is not. */
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

    /** Reads the standard input if it is not too much, see {@link #readAll(InputStream, String, int, String)}. */
    public static byte[] readAll(Streams streams, int most, String expected) {
        try {
            return readAll(new BufferedInputStream(streams.in()), INPUT, most, expected);
        } catch (IOException problem) {
            throw unreadable(problem);
        }
    }

    /**
     * All that an input holds, if that is not too much.
     *
     * @param source   names it in errors
     * @param most     how many bytes there may be
     * @param expected says in errors what it should be, such as {@code a recording}
     * @throws IOException    if it cannot be read
     * @throws InputException if it holds more
     */
    public static byte[] readAll(InputStream in, String source, int most, String expected) throws IOException {
        byte[] bytes = in.readNBytes(most + 1);
        if (bytes.length > most) {
            throw new InputException(source + ": found more than " + most + " bytes, expected " + expected
                + ", which is shorter");
        }
        return bytes;
    }

    /** A replay that comes on the standard input; read line by line. */
    public static ReplayReader openReplay(Streams streams) {
        try {
            return new ReplayReader(streams.in(), INPUT);
        } catch (UncheckedIOException problem) {
            throw unreadable(problem.getCause());
        }
    }

    /** A replay that came on the standard input. */
    public static ReplayReader openReplay(byte[] replay) {
        return new ReplayReader(new ByteArrayInputStream(replay), INPUT);
    }

    /** A scene that comes on the standard input. */
    public static SceneText readScene(Streams streams) {
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
