package steward.replay.sign;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.attribute.FileAttribute;
import java.util.Base64;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import steward.files.InputException;
import steward.files.OutputFiles;

/** PEM file, read and written: bytes in base64 between {@code -----BEGIN KIND-----} and {@code -----END KIND-----}. */
final class PemFile {

    private static final int COLUMNS = 64;
    /** A key takes some hundred bytes. */
    private static final int MOST_BYTES = 1 << 14;
    private static final Pattern FORM =
        Pattern.compile("\\s*-----BEGIN ([A-Z0-9 ]+)-----\\s+([A-Za-z0-9+/=\\s]*)-----END \\1-----\\s*");

    /**
     * @param expected for errors
     * @throws InputException if it cannot be read, or is not PEM of that kind
     */
    static byte[] read(Path file, String kind, String expected) {
        String text;
        try (InputStream in = Files.newInputStream(file)) {
            text = new String(in.readNBytes(MOST_BYTES), StandardCharsets.ISO_8859_1);
        } catch (NoSuchFileException problem) {
            throw new InputException(file + ": found no such file, expected " + expected);
        } catch (IOException problem) {
            if (Files.isDirectory(file)) {
                throw new InputException(file + ": found a folder, expected " + expected);
            }
            throw new InputException(file + ": cannot be read: " + reason(problem) + ", expected " + expected);
        }
        Matcher form = FORM.matcher(text);
        if (!form.matches()) {
            throw new InputException(file + ": found no key in PEM, expected " + expected);
        }
        if (!form.group(1).equals(kind)) {
            throw new InputException(file + ": found a " + form.group(1).toLowerCase(Locale.ROOT)
                + ", expected " + expected);
        }
        try {
            return Base64.getMimeDecoder().decode(form.group(2));
        } catch (IllegalArgumentException problem) {
            throw new InputException(file + ": found damaged base64, expected " + expected);
        }
    }

    /** True if there is such a file, and it begins as one of that kind. */
    static boolean isOf(Path file, String kind) {
        try (InputStream in = Files.newInputStream(file)) {
            String begin = "-----BEGIN " + kind + "-----";
            return new String(in.readNBytes(begin.length()), StandardCharsets.ISO_8859_1).equals(begin);
        } catch (IOException problem) {
            return false;
        }
    }

    /** @throws InputException if there is such a file */
    static void checkNew(Path file) {
        if (Files.exists(file)) {
            throw exists(file);
        }
    }

    private static InputException exists(Path file) {
        return new InputException(file + ": exists already, and is kept: a key that is lost signs nothing any more");
    }

    /** @param secret whether only the owner may read it, from its first moment on */
    static void write(Path file, String kind, byte[] bytes, boolean secret) {
        String text = "-----BEGIN " + kind + "-----\n"
            + Base64.getMimeEncoder(COLUMNS, new byte[] {'\n'}).encodeToString(bytes)
            + "\n-----END " + kind + "-----\n";
        try {
            Files.createFile(file, secret ? OutputFiles.ownerOnly() : new FileAttribute<?>[0]);
            Files.writeString(file, text, StandardCharsets.US_ASCII);
        } catch (FileAlreadyExistsException problem) {
            throw exists(file);
        } catch (IOException problem) {
            throw new InputException(file + ": cannot be written: " + reason(problem));
        }
    }

    private static String reason(IOException problem) {
        return problem instanceof AccessDeniedException ? "no permission"
            : problem instanceof NoSuchFileException ? "there is no such folder" : problem.getMessage();
    }
}
