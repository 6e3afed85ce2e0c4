package steward.files;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.NoSuchFileException;
import java.nio.file.OpenOption;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.FileAttribute;
import java.nio.file.attribute.PosixFilePermission;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import java.util.Set;

/** Files for replays and pages, opened before the match is played, so that errors are found early. */
public final class OutputFiles {

    private OutputFiles() { }

    /** A path as it was typed. */
    public static Path path(String typed) {
        if (typed.isEmpty()) {
            throw new InputException("'': found an empty file name, expected a file or folder");
        }
        try {
            return Path.of(typed);
        } catch (InvalidPathException problem) {
            throw new InputException("'" + typed + "': found no possible file name: " + problem.getReason());
        }
    }

    /**
     * A new file; with {@code overwrite} also one that exists. Every line is handed to the system at once, so that
     * recorded turns survive a crash.
     *
     * @throws InputException if it cannot be written, or exists and is not to be overwritten
     */
    public static OutputStream open(Path file, boolean overwrite) {
        check(file, overwrite);
        try {
            return create(file, overwrite);
        } catch (FileAlreadyExistsException problem) {
            throw exists(file);
        } catch (IOException problem) {
            throw new InputException(file + ": cannot be written: " + reason(file, problem));
        }
    }

    /** @throws IOException also if it exists and is not to be overwritten */
    static OutputStream create(Path file, boolean overwrite) throws IOException {
        OpenOption[] options = overwrite
            ? new OpenOption[] {StandardOpenOption.WRITE, StandardOpenOption.CREATE,
                StandardOpenOption.TRUNCATE_EXISTING}
            : new OpenOption[] {StandardOpenOption.WRITE, StandardOpenOption.CREATE_NEW};
        return Files.newOutputStream(file, options);
    }

    /**
     * Checks a file without opening it.
     *
     * @throws InputException if it is a folder, or exists and is not to be overwritten
     */
    public static void check(Path file, boolean overwrite) {
        if (Files.isDirectory(file)) {
            throw new InputException(file + ": found a folder, expected the name of a file");
        }
        if (!overwrite && Files.exists(file)) {
            throw exists(file);
        }
    }

    /** Returns a name for a copy beside a file, such as {@code league.db.before-drop-1}: the first that is free. */
    public static Path copyBeside(Path file, String occasion) {
        for (int number = 1;; number++) {
            Path copy = file.resolveSibling(file.getFileName() + "." + occasion + "-" + number);
            if (Files.notExists(copy)) {
                return copy;
            }
        }
    }

    /**
     * Makes sure that a folder exists and can be written into.
     *
     * @throws InputException if it cannot be made or written into
     */
    public static void prepareFolder(Path folder) {
        try {
            if (!Files.isDirectory(folder)) {
                Files.createDirectory(folder);
            }
            if (!Files.isWritable(folder)) {
                throw new InputException(folder + ": cannot be written into: no permission");
            }
        } catch (FileAlreadyExistsException problem) {
            throw new InputException(folder + ": found a file, expected a folder, there or to be made");
        } catch (IOException problem) {
            throw new InputException(folder + ": cannot be made: " + reason(folder, problem));
        }
    }

    /** The right of the owner alone to read and write a new file, where the system knows such rights. */
    public static FileAttribute<?>[] ownerOnly() {
        return FileSystems.getDefault().supportedFileAttributeViews().contains("posix")
            ? new FileAttribute<?>[] {
                PosixFilePermissions.asFileAttribute(PosixFilePermissions.fromString("rw-------"))}
            : new FileAttribute<?>[0];
    }

    /**
     * Makes a folder, with those above it, if it is not there, and takes the permissions of others away from it.
     *
     * @throws InputException if it cannot be made
     */
    public static void privateFolder(Path folder) {
        try {
            Files.createDirectories(folder);
            Set<PosixFilePermission> mine = PosixFilePermissions.fromString("rwx------");
            if (folder.getFileSystem().supportedFileAttributeViews().contains("posix")
                && !Files.getPosixFilePermissions(folder).equals(mine)) {
                Files.setPosixFilePermissions(folder, mine);
            }
        } catch (IOException problem) {
            throw new InputException(folder + ": cannot be made: " + reason(folder, problem));
        }
    }

    /** Takes the permissions of others away from a folder. @return what was done or is left to do; empty if nothing */
    public static String closeToOthers(Path folder) {
        try {
            Set<PosixFilePermission> before = Files.getPosixFilePermissions(folder);
            if (PosixFilePermissions.fromString("rwx------").containsAll(before)) {
                return "";
            }
            String open = folder + " was open to other users of this machine, with its keys and replays ("
                + PosixFilePermissions.toString(before) + ")";
            try {
                privateFolder(folder);
                return open + ": now it is its owner's alone";
            } catch (InputException notOurs) {
                return open + " and still is, because it is not yours: its owner can chmod 700 " + folder;
            }
        } catch (IOException | UnsupportedOperationException unknown) {
            return "";
        }
    }

    /**
     * Replaces a file by a whole new one: a reader sees the old or the new one, never a part.
     *
     * @throws IOException if it cannot be written
     */
    public static void replace(Path file, byte[] content) throws IOException {
        Path part = file.resolveSibling(file.getFileName() + ".part");
        Files.write(part, content);
        Files.move(part, file, StandardCopyOption.ATOMIC_MOVE);
    }

    /** True if both are the same file, there already or about to be; {@code null} is never the same. */
    public static boolean isSame(Path one, Path other) {
        if (one == null || other == null) {
            return false;
        }
        try {
            return one.toAbsolutePath().normalize().equals(other.toAbsolutePath().normalize())
                || Files.exists(one) && Files.exists(other) && Files.isSameFile(one, other);
        } catch (IOException problem) {
            return false;
        }
    }

    public static InputException exists(Path file) {
        return new InputException(file + ": exists already, and is kept",
            List.of(new Remedied.Remedy("overwrite", "would replace it")));
    }

    /** Returns why a file or folder cannot be written, without its name. */
    public static String reason(Path file, IOException problem) {
        Path folder = file.toAbsolutePath().getParent();
        if (problem instanceof AccessDeniedException) {
            return "no permission" + owner(Files.exists(file) ? file : folder);
        }
        if (folder != null && !Files.exists(folder)) {
            return "there is no folder " + folder;
        }
        if (folder != null && !Files.isDirectory(folder)) {
            return folder + " is not a folder";
        }
        return problem instanceof NoSuchFileException ? "there is no such place"
            : problem instanceof FileSystemException named && named.getReason() != null ? named.getReason()
            : problem.getMessage();
    }

    /** Whose a file is that this user may not use, in brackets; nothing if it is this user's or nobody knows. */
    public static String owner(Path file) {
        try {
            String owner = Files.getOwner(file).getName();
            return owner.equals(System.getProperty("user.name")) ? "" : " (it belongs to " + owner + ")";
        } catch (IOException | UnsupportedOperationException unknown) {
            return "";
        }
    }
}
