package steward.league;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.AccessDeniedException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Supplier;
import steward.contest.seeds.SeedFile;
import steward.contest.seeds.Seeds;
import steward.files.InputException;
import steward.files.OutputFiles;
import steward.scene.SceneFiles;
import steward.scene.json.JsonLimits;
import steward.scene.json.SceneException;
import steward.text.Utf8Text;
import steward.text.Utf8Text.NotUtf8Exception;

/**
 * The folder of a league and the paths in it: {@code league.json}, {@code league.db}, {@code league.lock}, the replays,
 * and the seed lists of {@link ChosenSeeds}.
 *
 * @param path as it was named
 */
public record LeagueFolder(Path path) {

    /** The file that a person edits. */
    public static final String SETTINGS = "league.json";
    /** Folder of a tournament's programs, beside its league. */
    public static final String PROGRAMS = "programs";
    /** A scene of the league's own. */
    public static final String SCENE = "scene.json";
    /** A list of seeds of the league's own. */
    public static final String SEEDS = "seeds.txt";

    /** File systems of other machines: SQLite's write-ahead log needs memory that all its users share. */
    private static final Set<String> REMOTE = Set.of("nfs", "nfs3", "nfs4", "cifs", "smb", "smb2", "smb3", "smbfs",
        "afs", "ncpfs", "9p", "v9fs", "fuse.sshfs", "fuse.rclone", "fuse.s3fs", "fuse.glusterfs", "glusterfs", "ceph",
        "fuse.ceph", "lustre", "gpfs", "beegfs", "ocfs2", "gfs2", "davfs", "fuse.davfs2", "prl_fs", "vboxsf",
        "webdav", "afpfs");

    /**
     * A league that is there.
     *
     * @throws InputException if there is none
     */
    public static LeagueFolder open(Path path) {
        if (Files.isDirectory(path) && !Files.isExecutable(path)) {
            throw new InputException(path + ": cannot be read: no permission" + OutputFiles.owner(path));
        }
        if (!Files.isRegularFile(path.resolve(SETTINGS))) {
            throw new InputException(path + ": found " + (Files.isDirectory(path) ? "a folder without " + SETTINGS
                : Files.exists(path) ? "a file" : "no such folder")
                + ", expected the folder of a league, as 'steward league init' makes it");
        }
        return new LeagueFolder(path);
    }

    /**
     * A league that is there and is about to be written to: the permissions of others are taken away from its folder.
     *
     * @param told gets one line if that had to be done or cannot be done
     * @throws InputException if there is none
     */
    public static LeagueFolder openToWrite(Path path, Consumer<String> told) {
        LeagueFolder folder = open(path);
        String closed = OutputFiles.closeToOthers(path);
        if (!closed.isEmpty()) {
            told.accept(closed);
        }
        return folder;
    }

    public Path settings() {
        return path.resolve(SETTINGS);
    }

    public Path database() {
        return path.resolve("league.db");
    }

    /** Returns the lock file, which a run holds while it plays. */
    public Path lock() {
        return path.resolve("league.lock");
    }

    public Path replays() {
        return path.resolve("replays");
    }

    /** A scene as it is named in the settings: a shipped scene's name, or a file of this folder. */
    public String scene(String named) {
        Path own = path.resolve(named);
        return !SceneFiles.shipped().contains(named) && Files.isRegularFile(own) ? own.toString() : named;
    }

    /** Returns the list of seeds that the settings name; {@code null} if they name none. */
    public SeedFile seeds(LeagueSettings settings) {
        return settings.seedFile() == null ? null : SeedFile.read(path.resolve(settings.seedFile()));
    }

    /** Returns the seeds that are played: the list, or numbers in a row. */
    public Seeds starts(LeagueSettings settings) {
        return settings.seedFile() == null ? Seeds.from(settings.seed()) : seeds(settings).seeds();
    }

    /**
     * Reads the settings.
     *
     * @throws SceneException if they are not as they should be
     * @throws InputException if they cannot be read
     */
    public LeagueSettings read() {
        Path file = settings();
        try {
            if (Files.size(file) > JsonLimits.BYTES) {
                throw new InputException(file + ": found a file of " + Files.size(file)
                    + " bytes, expected at most " + JsonLimits.BYTES);
            }
            return LeagueReader.read(Utf8Text.decode(Files.readAllBytes(file), file.toString(), "a text in UTF-8"),
                file.toString()).located(this::located);
        } catch (NotUtf8Exception problem) {
            throw new InputException(problem.getMessage());
        } catch (AccessDeniedException problem) {
            throw new InputException(file + ": cannot be read: no permission");
        } catch (IOException problem) {
            throw new InputException(file + ": cannot be read: " + OutputFiles.reason(file, problem));
        }
    }

    /** A bot's folder as the file names it, relative to the league's, made absolute; {@code null} stays. */
    private String located(String named) {
        return named == null ? null : path.toAbsolutePath().resolve(named).normalize().toString();
    }

    /**
     * A bot's folder as it is written: relative if it is within the league's, or that of a tournament's programs beside
     * it, which then can be moved.
     */
    private String stored(String folder) {
        Path own = path.toAbsolutePath().normalize();
        if (folder == null || !Path.of(folder).startsWith(own)
            && !Path.of(folder).startsWith(own.resolveSibling(PROGRAMS))) {
            return folder;
        }
        String within = own.relativize(Path.of(folder)).toString();
        return within.isEmpty() ? "." : within;
    }

    /** Opens what the settings name; where that is refused, the error says that it is they who name it. */
    public <T> T named(Supplier<T> opening) {
        try {
            return opening.get();
        } catch (InputException | SceneException problem) {
            if (problem.getMessage().startsWith(path.toString())) {
                throw problem;
            }
            throw new InputException(settings() + ": " + problem.getMessage());
        }
    }

    /**
     * Replaces the settings as a whole: a run that is under way sees the old ones or the new ones.
     *
     * @throws InputException if they could not be read again, or not be written
     */
    public void write(LeagueSettings settings) {
        String text = LeagueText.write(settings.located(this::stored));
        try {
            LeagueReader.read(text, settings().toString());
        } catch (SceneException unusable) {
            throw new InputException(unusable.getMessage() + "; nothing was written");
        }
        try {
            OutputFiles.replace(settings(), text.getBytes(StandardCharsets.UTF_8));
        } catch (IOException problem) {
            throw new InputException(settings() + ": cannot be written: " + OutputFiles.reason(settings(), problem));
        }
    }

    /**
     * Refuses a folder of another machine.
     *
     * @param folder that exists
     */
    public static void refuseRemote(Path folder) {
        try {
            refuseRemote(folder, Files.getFileStore(folder).type());
        } catch (IOException unknown) {
            // What it is on cannot be found out: the database will say whether it can be used.
            return;
        }
    }

    static void refuseRemote(Path folder, String type) {
        if (REMOTE.contains(type.toLowerCase(Locale.ROOT))) {
            throw new InputException(folder + ": found a file system of another machine (" + type + "), expected one "
                + "of this machine: the write-ahead log of the database is not safe over a network");
        }
    }
}
