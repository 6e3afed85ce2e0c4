package steward.lab.bench.section;

import java.io.FileDescriptor;
import java.io.FileInputStream;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;

/**
 * Bot program that does no work: it answers each line with the same line. So the time of a match with it is that of the
 * referee and the system.
 */
public final class FixedAnswerBot {

    private FixedAnswerBot() { }

    /** @param arguments the answer, without line end */
    public static void main(String[] arguments) throws IOException {
        byte[] answer = (arguments[0] + "\n").getBytes(StandardCharsets.UTF_8);
        byte[] buffer = new byte[1 << 16];
        try (InputStream in = new FileInputStream(FileDescriptor.in);
                OutputStream out = new FileOutputStream(FileDescriptor.out)) {
            for (int count = in.read(buffer); count > 0; count = in.read(buffer)) {
                if (buffer[count - 1] == '\n') {
                    out.write(answer);
                }
            }
        } catch (IOException gone) {
            // The referee no longer reads at the end of a match; nothing is lost.
            return;
        }
    }
}
