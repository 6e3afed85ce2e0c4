package steward.bot.command;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.FileVisitOption;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * Program of a bot: the words that start it, its working folder, and the files that identify it.
 *
 * @param words  the program and its arguments
 * @param folder absolute
 * @param named  its files as a person lists them, relative to the folder; {@code null} for those that the words name
 */
public record Program(List<String> words, Path folder, List<String> named) {

    private static final int MOST_CLASSES = 1000;
    private static final Set<String> CLASS_PATH = Set.of("-cp", "-classpath", "--class-path");
    /** Options of a JVM whose value is the next word. */
    private static final Set<String> WITH_VALUE = Set.of("-p", "--module-path", "--add-modules", "--add-opens",
        "--add-exports", "--add-reads");
    /** Options after which a program finds the name of a file that it writes. */
    private static final Pattern WRITTEN = Pattern.compile(
        "--?(\\w+-)*(log|logs|logfile|o|out|output|save|cache|trace|dump)(-\\w+)*");
    private static final String CLASS = ".class";

    public Program {
        words = List.copyOf(words);
        folder = folder.toAbsolutePath().normalize();
        named = named == null ? null : List.copyOf(named);
    }

    /** A program that is started in the current folder. */
    public static Program here(List<String> words) {
        return new Program(words, Path.of(""), null);
    }

    /** Returns this program with other words, which do the same. */
    public Program started(List<String> others) {
        return new Program(others, folder, files().stream().map(Path::toString).toList());
    }

    /**
     * Files that make it this program, relative to its folder unless they are written otherwise: those that are listed,
     * or every word that is a file, but for logs and what an option such as {@code --out} names, and the classes that a
     * call of {@code java} names.
     */
    public List<Path> files() {
        if (named != null) {
            return named.stream().map(Path::of).toList();
        }
        Set<Path> files = new LinkedHashSet<>();
        for (int k = 0; k < words.size(); k++) {
            String word = words.get(k);
            Path file = path(word);
            boolean written = word.endsWith(".log") || k > 0 && WRITTEN.matcher(words.get(k - 1)).matches();
            if (file != null && !written && !word.isEmpty() && Files.isRegularFile(folder.resolve(file))) {
                files.add(file);
            }
        }
        if (!words.isEmpty() && isJava(words.get(0))) {
            addClasses(files);
        }
        return List.copyOf(files);
    }

    /** Its {@link #files()}, absolute. */
    public List<Path> paths() {
        return files().stream().map(file -> folder.resolve(file).normalize()).toList();
    }

    /** Returns what changes when one of its files has been touched, or is missing. No file is read. */
    public String stamp() {
        StringBuilder stamps = new StringBuilder();
        for (Path file : paths()) {
            stamps.append(file).append(' ').append(stamp(file)).append('\n');
        }
        return stamps.toString();
    }

    /** Size, time and place on the disk of a file; {@code none} if it is not there. */
    public static String stamp(Path file) {
        try {
            BasicFileAttributes found = Files.readAttributes(file, BasicFileAttributes.class);
            return found.size() + " " + found.lastModifiedTime().toInstant() + " " + found.fileKey();
        } catch (IOException gone) {
            return "none";
        }
    }

    static Path path(String word) {
        try {
            return Path.of(word);
        } catch (InvalidPathException none) {
            return null;
        }
    }

    private static boolean isJava(String program) {
        return program.substring(program.lastIndexOf('/') + 1).equals("java");
    }

    /** Adds the jars and the classes of a class path: of folders, the classes beside the main class and below it. */
    private void addClasses(Set<Path> files) {
        String classPath = ".";
        String main = null;
        for (int k = 1; k < words.size() && main == null; k++) {
            String word = words.get(k);
            if (word.equals("-jar") || word.equals("-m") || word.equals("--module")) {
                return;                                // a jar is a word by itself
            }
            if (CLASS_PATH.contains(word) && k + 1 < words.size()) {
                classPath = words.get(++k);
            } else if (word.startsWith("--class-path=")) {
                classPath = word.substring(word.indexOf('=') + 1);
            } else if (WITH_VALUE.contains(word)) {
                k++;
            } else if (!word.startsWith("-")) {
                main = word;
            }
        }
        for (String entry : classPath.split(":")) {
            Path found = path(entry.isEmpty() ? "." : entry);
            if (main != null && found != null && Files.isRegularFile(folder.resolve(found))) {
                files.add(found);
            } else if (main != null && found != null && path(main) != null) {
                addClasses(found, main, files);
            }
        }
    }

    private void addClasses(Path entry, String main, Set<Path> files) {
        int dot = main.indexOf('.');
        Path top = folder.resolve(entry);
        boolean inPackage = dot > 0;
        Path from = inPackage ? top.resolve(main.substring(0, dot)) : top;
        if (!Files.isRegularFile(top.resolve(main.replace('.', '/') + CLASS))) {
            return;
        }
        try (Stream<Path> all = Files.walk(from, inPackage ? Integer.MAX_VALUE : 1, FileVisitOption.FOLLOW_LINKS)) {
            List<Path> classes = new ArrayList<>(all.filter(file -> file.getFileName().toString().endsWith(CLASS)
                && Files.isRegularFile(file)).limit(MOST_CLASSES).toList());
            classes.sort(Comparator.naturalOrder());
            classes.forEach(file -> files.add(entry.isAbsolute() ? file : folder.relativize(file.normalize())));
        } catch (IOException | UncheckedIOException unreadable) {
            return;
        }
    }
}
