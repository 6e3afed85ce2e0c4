package steward.cli.tournament;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.text.Normalizer;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import steward.files.InputException;
import steward.files.OutputFiles;
import steward.league.LeagueFolder;
import steward.text.TextFormat;

/**
 * The programs in a tournament's folder: their names, sources, languages and authors.
 *
 * @param programs in the order of their file names
 * @param others   names of files and folders that are no programs
 */
record Programs(List<Program> programs, List<String> others) {

    /** Folder of the copies, in the tournament's. */
    static final String FOLDER = LeagueFolder.PROGRAMS;
    /** File beside a copy with the name of what was handed in. */
    static final String HANDED_IN_AS = "handed-in-as.txt";

    private static final int LONGEST = 80;
    /** Names that a league keeps for parameters that are tried. */
    private static final String TUNED = "tune.";

    /** Kind of program, by how it is made ready to run. */
    enum Kind {
        PYTHON("bot.py"), JS("bot.cjs"), MODULE("bot.mjs"), JAVA("source.txt"), CPP("bot.cpp"), FOLDER("folder");

        /** The name of its copy. */
        final String copy;

        Kind(String copy) {
            this.copy = copy;
        }
    }

    /**
     * A program as its author hands it in.
     *
     * @param name   in the table: letters and digits of any language, dots, underscores and hyphens
     * @param source a file, or a folder with a file {@code run}
     */
    record Program(String name, Path source, Kind kind) { }

    /**
     * Finds the programs.
     *
     * @param into the tournament's folder, which is none of them; a file has the name there that it had before
     * @throws InputException if there are none, or the folder cannot be read
     */
    static Programs in(Path folder, Path into) {
        List<Path> entries = new ArrayList<>();
        try (Stream<Path> files = Files.list(folder)) {
            files.filter(file -> !file.getFileName().toString().startsWith("."))
                .filter(file -> !file.toAbsolutePath().normalize().equals(into.toAbsolutePath().normalize()))
                .sorted().forEach(entries::add);
        } catch (IOException problem) {
            throw new InputException(folder + ": " + (Files.isDirectory(folder) ? "cannot be read: "
                + OutputFiles.reason(folder, problem) : (Files.exists(folder) ? "found a file" : "found no such folder")
                + ", expected a folder with programs"));
        }
        List<Program> programs = new ArrayList<>();
        List<String> others = new ArrayList<>();
        Map<String, String> known = known(into.resolve(FOLDER));
        Set<String> names = new HashSet<>();
        entries.forEach(entry -> Optional.ofNullable(known.get(entry.getFileName().toString())).ifPresent(name ->
            names.add(name.toLowerCase(Locale.ROOT))));
        for (Path entry : entries) {
            Kind kind = kind(entry);
            String file = entry.getFileName().toString();
            if (kind == null) {
                others.add(file);
            } else {
                String earlier = known.remove(file);
                programs.add(new Program(earlier != null ? earlier : unique(name(entry, kind), names), entry, kind));
            }
        }
        if (programs.isEmpty()) {
            throw new InputException(folder + ": found no program" + (others.isEmpty() ? "" : " among "
                + TextFormat.count(others.size(), "file")) + ", expected source files that end in .py, .java, .cpp or "
                + ".js, or folders with a file 'run' that holds a command");
        }
        return new Programs(programs, others);
    }

    /** Names that files have got earlier, by the name of the file. */
    private static Map<String, String> known(Path programs) {
        Map<String, String> known = new HashMap<>();
        try (Stream<Path> folders = Files.list(programs)) {
            for (Path each : folders.sorted().toList()) {
                if (Files.isRegularFile(each.resolve(HANDED_IN_AS))) {
                    known.put(Files.readString(each.resolve(HANDED_IN_AS)), each.getFileName().toString());
                }
            }
        } catch (IOException none) {
            return known;
        }
        return known;
    }

    private static Kind kind(Path entry) {
        if (Files.isDirectory(entry, LinkOption.NOFOLLOW_LINKS)) {
            return Files.exists(entry.resolve("run"), LinkOption.NOFOLLOW_LINKS) ? Kind.FOLDER : null;
        }
        String name = entry.getFileName().toString().toLowerCase(Locale.ROOT);
        return name.endsWith(".py") ? Kind.PYTHON : name.endsWith(".mjs") ? Kind.MODULE
            : name.endsWith(".js") || name.endsWith(".cjs") ? Kind.JS
            : name.endsWith(".java") ? Kind.JAVA
            : name.endsWith(".cpp") || name.endsWith(".cc") || name.endsWith(".cxx") ? Kind.CPP : null;
    }

    private static String name(Path entry, Kind kind) {
        String file = entry.getFileName().toString();
        String bare = kind == Kind.FOLDER ? file : file.substring(0, file.lastIndexOf('.'));
        String name = Normalizer.normalize(bare, Normalizer.Form.NFC).replaceAll("[^\\p{L}\\p{M}\\p{N}._-]+", "-")
            .replaceAll("^[-.]+|-+$", "").replaceFirst("^tune\\.", "tune-");
        int end = Math.min(LONGEST, name.length());
        name = name.substring(0, end > 0 && Character.isHighSurrogate(name.charAt(end - 1)) ? end - 1 : end);
        return name.isEmpty() || name.startsWith(TUNED) ? "bot" : name;
    }

    private static String unique(String name, Set<String> names) {
        String found = name;
        for (int k = 2; !names.add(found.toLowerCase(Locale.ROOT)); k++) {
            found = name + "-" + k;
        }
        return found;
    }
}
