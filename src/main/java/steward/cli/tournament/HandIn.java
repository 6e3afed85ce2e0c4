package steward.cli.tournament;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileVisitOption;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.attribute.BasicFileAttributes;
import java.security.DigestOutputStream;
import java.security.MessageDigest;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.Set;
import java.util.TreeMap;
import steward.files.Folders;
import steward.files.InputException;
import steward.files.OutputFiles;
import steward.files.Sha256;
import steward.text.TextFormat;

/**
 * File or folder that somebody who is not trusted hands in, to be copied. Only regular files are opened, and no link is
 * followed; everything else is left out and named. Size and number are checked before anything is copied.
 *
 * @param source  a file or a folder
 * @param files   the regular files by their path below the source, with their stamps; of a file itself one, unnamed
 * @param leftOut what is no regular file, with the reason
 * @param bytes   size of all files, as they appear
 */
record HandIn(Path source, TreeMap<String, String> files, List<String> leftOut, long bytes) {

    /** Folders in folders. */
    private static final int DEEPEST = 40;
    private static final int NAMED = 10;
    private static final int BUFFER = 1 << 16;
    private static final long MEGABYTE = 1_000_000;

    /**
     * Bounds of one program.
     *
     * @param megabytes of all its files together
     * @param files     files and folders
     */
    record Bounds(int megabytes, int files) { }

    /**
     * Looks at a hand-in; opens no file.
     *
     * @throws InputException if it is neither a regular file nor a folder, or too large
     * @throws IOException    if a folder cannot be read
     */
    static HandIn of(Path source, Bounds bounds) throws IOException {
        TreeMap<String, String> files = new TreeMap<>();
        List<String> leftOut = new ArrayList<>();
        long[] sums = new long[2];
        Files.walkFileTree(source, Set.<FileVisitOption>of(), DEEPEST + 1, new SimpleFileVisitor<>() {
            @Override
            public FileVisitResult preVisitDirectory(Path folder, BasicFileAttributes found) {
                return count(0);
            }

            @Override
            public FileVisitResult visitFile(Path file, BasicFileAttributes found) {
                String name = source.relativize(file).toString();
                if (found.isDirectory()) {
                    throw new InputException("found folders more than " + DEEPEST + " deep, expected fewer");
                } else if (!source.resolve(name).equals(file)) {
                    leftOut.add(TextFormat.plain(name) + " (a name in another encoding)");
                    return count(0);
                } else if (found.isRegularFile()) {
                    files.put(name, stamp(found));
                    return count(found.size());
                }
                leftOut.add(TextFormat.plain(name) + " (" + kind(found) + ")");
                return count(0);
            }

            @Override
            public FileVisitResult visitFileFailed(Path file, IOException problem) throws IOException {
                if (file.equals(source)) {
                    throw problem;
                }
                leftOut.add(TextFormat.plain(source.relativize(file).toString()) + " ("
                    + OutputFiles.reason(file, problem) + ")");
                return count(0);
            }

            private FileVisitResult count(long bytes) {
                sums[0]++;
                sums[1] += bytes;
                if (sums[0] > bounds.files()) {
                    throw new InputException("found more than " + bounds.files()
                        + " files and folders, expected fewer (--most-files)");
                }
                if (sums[1] > bounds.megabytes() * MEGABYTE) {
                    throw new InputException("found more than " + bounds.megabytes()
                        + " MB, expected less (--most-megabytes)");
                }
                return FileVisitResult.CONTINUE;
            }
        });
        if (files.isEmpty()) {
            throw new InputException("found " + (Files.isDirectory(source, LinkOption.NOFOLLOW_LINKS)
                ? "no regular file" + (leftOut.isEmpty() ? "" : " among " + String.join(", ", leftOut))
                : leftOut.get(0).replaceAll("^ ?\\(|\\)$", "")) + ", expected a regular file");
        }
        return new HandIn(source, files, leftOut, sums[1]);
    }

    private static String kind(BasicFileAttributes found) {
        return found.isSymbolicLink() ? "a link" : "a pipe, socket or device";
    }

    private static String stamp(BasicFileAttributes found) {
        return found.size() + " " + found.lastModifiedTime().toInstant() + " " + found.fileKey();
    }

    /** Parts that are left out, in words; {@code null} for none. */
    String left() {
        return leftOut.isEmpty() ? null : "Left out, as only regular files are copied: "
            + String.join(", ", leftOut.subList(0, Math.min(NAMED, leftOut.size())))
            + (leftOut.size() > NAMED ? " and " + (leftOut.size() - NAMED) + " more" : "");
    }

    /**
     * Copies the files; an earlier copy is replaced as a whole.
     *
     * @param target a file, or for a folder a folder
     * @return digest of names and contents
     * @throws InputException if a file is no longer what it was when it was looked at
     */
    String copy(Path target) throws IOException {
        MessageDigest digest = Sha256.begin();
        Path fresh = target.resolveSibling(target.getFileName() + ".new");
        clear(fresh);
        for (String name : files.keySet()) {
            Path to = name.isEmpty() ? fresh : fresh.resolve(name);
            Files.createDirectories(to.getParent());
            digest.update((name + "\n").getBytes(StandardCharsets.UTF_8));
            copy(name.isEmpty() ? source : source.resolve(name), to, files.get(name), digest);
        }
        clear(target);
        Files.move(fresh, target);
        return HexFormat.of().formatHex(digest.digest());
    }

    private static void clear(Path path) throws IOException {
        if (Files.exists(path, LinkOption.NOFOLLOW_LINKS)) {
            Folders.delete(path);
        }
    }

    /** Opens what was a regular file a moment ago; a link in its place is refused by the system. */
    private static void copy(Path from, Path to, String stamp, MessageDigest digest) throws IOException {
        BasicFileAttributes found = Files.readAttributes(from, BasicFileAttributes.class, LinkOption.NOFOLLOW_LINKS);
        if (!found.isRegularFile() || !stamp(found).equals(stamp)) {
            throw changed(from);
        }
        try (InputStream in = Files.newInputStream(from, LinkOption.NOFOLLOW_LINKS);
             OutputStream out = new DigestOutputStream(Files.newOutputStream(to), digest)) {
            byte[] buffer = new byte[BUFFER];
            long left = found.size();
            for (int read = in.read(buffer); read >= 0; read = in.read(buffer)) {
                left -= read;
                if (left < 0) {
                    throw changed(from);
                }
                out.write(buffer, 0, read);
            }
        }
        if (from.toFile().canExecute() && !to.toFile().setExecutable(true)) {
            throw new IOException(to + " cannot be made executable");
        }
    }

    private static InputException changed(Path file) {
        return new InputException(file.getFileName() + " changed while it was copied; call again");
    }

    /** True if the files at the source are no longer those that were copied. */
    boolean isChanged(Bounds bounds) {
        try {
            return !of(source, bounds).files().equals(files);
        } catch (IOException | InputException other) {
            return true;
        }
    }
}
