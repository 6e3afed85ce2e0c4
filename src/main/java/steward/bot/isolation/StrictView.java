package steward.bot.isolation;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import steward.bot.command.Program;

/**
 * File system that a bot sees at {@link SandboxLevel#STRICT}. It starts empty; then it shows the machine's programs and
 * libraries, the bot's interpreter, its own files, and files that the user adds by name. Symbolic links on the way to
 * them are recreated. Files of other bots, and files that the isolation names, are hidden even inside shown folders.
 *
 * @param entries what is made, by path; folders before what is in them
 */
record StrictView(Map<Path, Entry> entries) {

    /** Folders before what is in them. */
    private static final Comparator<Path> ORDER = Comparator.comparingInt(Path::getNameCount)
        .thenComparing(Comparator.naturalOrder());
    private static final int MOST_LINKS = 40;

    /** Ways to make a path inside. */
    enum Treatment { SHOW, LINK, EMPTY_FOLDER, HIDE_FOLDER, HIDE_FILE }

    /**
     * A path inside.
     *
     * @param target of a link, as it is written; otherwise {@code null}
     */
    record Entry(Treatment treatment, Path target) { }

    /** Collects paths without symbolic links, and the links that led to them. */
    private static final class Resolver {

        private final Map<Path, Path> links = new TreeMap<>(ORDER);

        /** The path that the system would find, or {@code null} if there is none that this user may look at. */
        Path resolve(Path path) {
            Path rest = path.toAbsolutePath().normalize();
            Path found = rest.getRoot();
            for (int links = 0; rest.getNameCount() > 0;) {
                Path next = found.resolve(rest.getName(0));
                rest = rest.getNameCount() > 1 ? rest.subpath(1, rest.getNameCount()) : Path.of("");
                if (!Files.isSymbolicLink(next)) {
                    found = next;
                } else if (++links <= MOST_LINKS) {
                    Path target = read(next);
                    if (target == null) {
                        return null;
                    }
                    this.links.put(next, target);
                    rest = found.resolve(target).resolve(rest).normalize();
                    found = rest.getRoot();
                } else {
                    return null;
                }
                if (rest.toString().isEmpty()) {
                    break;
                }
            }
            return Files.exists(found) ? found : null;
        }

        private static Path read(Path link) {
            try {
                return Files.readSymbolicLink(link);
            } catch (IOException gone) {
                return null;
            }
        }
    }

    /**
     * The view of a bot.
     *
     * @param others the bots whose files it is not to see
     */
    static StrictView of(Program bot, List<Program> others, Isolation isolation) {
        Resolver resolver = new Resolver();
        Set<Path> shown = new TreeSet<>(ORDER);
        Set<Path> own = new LinkedHashSet<>(OwnFiles.of(bot));
        own.addAll(isolation.visible());
        Set<Path> mine = new TreeSet<>(ORDER);
        own.forEach(path -> add(new Resolver().resolve(path), mine));
        OwnFiles.named(bot.words(), bot.folder()).forEach(path -> add(new Resolver().resolve(path), mine));
        bot.paths().forEach(path -> add(new Resolver().resolve(path), mine));
        SystemFiles.shown().forEach(path -> add(resolver.resolve(path), shown));
        own.stream().filter(path -> !path.startsWith("/dev") && !path.startsWith("/proc"))
            .forEach(path -> add(resolver.resolve(path), shown));
        Map<Path, Path> links = new TreeMap<>(resolver.links);
        Set<Path> folders = new TreeSet<>(ORDER);
        for (Path folder : List.of(OwnFiles.home(), bot.folder())) {
            Path real = resolver.resolve(folder);
            folders.add(real == null ? folder : real);
        }
        links.putAll(resolver.links);
        Set<Path> hidden = new TreeSet<>(ORDER);
        for (Path path : hidden(others, isolation)) {
            Path real = new Resolver().resolve(path);
            if (real != null && !mine.contains(real)) {
                add(real, hidden);
            }
        }
        return of(shown, hidden, links, folders);
    }

    private static void add(Path path, Set<Path> paths) {
        if (path != null && path.getNameCount() > 0) {
            paths.add(path);
        }
    }

    /** Paths that are hidden also in folders that are shown. */
    private static Set<Path> hidden(List<Program> others, Isolation isolation) {
        Set<Path> hidden = new LinkedHashSet<>(isolation.hidden());
        for (Program other : others) {
            OwnFiles.of(other).stream().filter(path -> !SystemFiles.holds(path)).forEach(hidden::add);
            OwnFiles.brought(other).stream().filter(path -> !SystemFiles.isCommon(path)).forEach(hidden::add);
        }
        return hidden;
    }

    /** Leaves out what a folder above it shows or hides in the same way. */
    private static StrictView of(Set<Path> shown, Set<Path> hidden, Map<Path, Path> links, Set<Path> folders) {
        Set<Path> all = new TreeSet<>(ORDER);
        List.of(shown, hidden, links.keySet(), folders).forEach(all::addAll);
        StrictView view = new StrictView(new TreeMap<>(ORDER));
        for (Path path : all) {
            boolean seen = view.shows(path);
            if (shown.contains(path)) {
                if (!seen) {
                    view.put(path, Treatment.SHOW, null);
                }
            } else if (hidden.contains(path) && (seen || !folders.contains(path))) {
                if (seen) {
                    view.put(path, Files.isDirectory(path) ? Treatment.HIDE_FOLDER : Treatment.HIDE_FILE, null);
                }
            } else if (links.containsKey(path)) {
                if (!seen) {
                    view.put(path, Treatment.LINK, links.get(path));
                }
            } else if (!seen && path.getNameCount() > 0) {
                view.put(path, Treatment.EMPTY_FOLDER, null);
            }
        }
        return view;
    }

    private void put(Path path, Treatment treatment, Path target) {
        entries.put(path, new Entry(treatment, target));
    }

    /** True if a path without symbolic links is there inside as it is outside. */
    boolean shows(Path path) {
        for (Path above = path; above != null; above = above.getParent()) {
            Entry entry = entries.get(above);
            if (entry != null && entry.treatment() != Treatment.EMPTY_FOLDER) {
                return entry.treatment() == Treatment.SHOW;
            }
        }
        return false;
    }
}
