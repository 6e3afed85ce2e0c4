package steward.bot.isolation;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;

/**
 * What a bot sees of the file system at {@link SandboxLevel#STRICT}: all of it but homes, folders for temporary files
 * and what runs, and the files of other bots; and of these its own files, and its interpreter, all the same.
 *
 * @param hidden  folders that are empty inside but for what is shown in them
 * @param treated what is shown or hidden, folders before what is in them
 */
record StrictView(List<Path> hidden, Map<Path, Treatment> treated) {

    /** Homes, foreign disks, sockets of what runs, temporary files of others. */
    private static final List<String> PRIVATE =
        List.of("/home", "/root", "/run", "/mnt", "/media", "/var/tmp", StrictSandbox.TEMPORARY);

    /** What belongs to the machine is never hidden, though another bot uses it. */
    private static final List<String> SYSTEM =
        List.of("/usr", "/bin", "/sbin", "/lib", "/lib32", "/lib64", "/libx32", "/etc", "/opt", "/nix", "/snap",
            "/dev", "/proc", "/sys");

    /** What is done to a file or folder. */
    enum Treatment { SHOW, HIDE_FOLDER, HIDE_FILE }

    static StrictView of(List<String> command, List<List<String>> others, List<Path> visible) {
        List<Path> hidden = hiddenFolders();
        List<Path> covers = new ArrayList<>(hidden);
        covers.add(Path.of(StrictSandbox.TEMPORARY));
        Set<Path> own = new LinkedHashSet<>(OwnFiles.of(command));
        own.addAll(visible);
        Map<Path, Treatment> treated = new TreeMap<>(Comparator.comparingInt(Path::getNameCount)
            .thenComparing(Comparator.naturalOrder()));
        for (List<String> other : others) {
            for (Path path : OwnFiles.of(other)) {
                boolean seen = covers.stream().noneMatch(path::startsWith) || own.stream().anyMatch(path::startsWith);
                if (seen && !own.contains(path) && path.getNameCount() > 0 && !isSystem(path)) {
                    hide(path, treated);
                }
            }
            for (Path file : OwnFiles.named(other)) {
                if (own.contains(file.getParent()) && !OwnFiles.named(command).contains(file) && !isSystem(file)) {
                    hide(file, treated);
                }
            }
        }
        for (Path path : own) {
            boolean covered = covers.stream().anyMatch(path::startsWith)
                || treated.keySet().stream().anyMatch(path::startsWith);
            if (covered && Files.exists(path)) {
                treated.put(path, Treatment.SHOW);
            }
        }
        return new StrictView(hidden, treated);
    }

    private static void hide(Path path, Map<Path, Treatment> treated) {
        if (Files.exists(path)) {
            treated.put(path, Files.isDirectory(path) ? Treatment.HIDE_FOLDER : Treatment.HIDE_FILE);
        }
    }

    /** See {@link SandboxSupport#hiddenInside}. */
    static List<Path> hiddenInside(Path folder) {
        List<Path> hidden = new ArrayList<>(hiddenFolders());
        hidden.add(Path.of(StrictSandbox.TEMPORARY));
        return hidden.stream().anyMatch(folder::startsWith) ? List.of()
            : hidden.stream().filter(each -> each.startsWith(folder)).sorted().toList();
    }

    /** Without the private folder for temporary files, which has a size of its own. */
    private static List<Path> hiddenFolders() {
        Set<Path> folders = new LinkedHashSet<>();
        for (String folder : PRIVATE) {
            folders.add(Path.of(folder));
        }
        folders.add(OwnFiles.home());
        folders.add(Path.of(System.getProperty("java.io.tmpdir")).toAbsolutePath().normalize());
        List<Path> kept = new ArrayList<>();
        for (Path folder : folders) {
            boolean inside = folders.stream().anyMatch(each -> !each.equals(folder) && folder.startsWith(each));
            boolean real = Files.isDirectory(folder) && !Files.isSymbolicLink(folder) && folder.getNameCount() > 0;
            if (real && !inside && !folder.equals(Path.of(StrictSandbox.TEMPORARY))) {
                kept.add(folder);
            }
        }
        return kept;
    }

    private static boolean isSystem(Path path) {
        return SYSTEM.stream().anyMatch(path::startsWith);
    }
}
