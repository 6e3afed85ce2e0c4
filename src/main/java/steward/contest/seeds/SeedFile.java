package steward.contest.seeds;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import steward.files.InputException;
import steward.files.OutputFiles;
import steward.text.TextFormat;
import steward.text.Utf8Text;
import steward.text.Utf8Text.NotUtf8Exception;

/**
 * File that lists seeds, one a line; a comment begins with {@code #}. A comment {@code # chosen by IDENTITY NAME} names
 * a bot whose games were used to choose the seeds.
 *
 * @param source   the file
 * @param text     all of it, so that a copy needs no second reading, which a pipe does not allow
 * @param choosers names of the bots by whose games they were chosen, by identity
 */
public record SeedFile(String source, String text, Seeds seeds, Map<String, String> choosers) {

    private static final String CHOSEN_BY = "# chosen by ";
    private static final Pattern CHOOSER = Pattern.compile("#\\s*chosen by ([0-9a-f]{32}) (\\S.*)");
    /** Largest file that is read, in bytes: some millions of seeds. */
    private static final int MOST_BYTES = 64 << 20;
    private static final int SHOWN = 40;
    private static final String BYTE_ORDER_MARK = "\uFEFF";

    public SeedFile {
        choosers = Map.copyOf(choosers);
    }

    /** Returns the line that names a bot by whose games seeds were chosen. @param identity 32 hexadecimal digits */
    public static String chooser(String identity, String name) {
        return CHOSEN_BY + identity + " " + name;
    }

    /**
     * Reads a file.
     *
     * @throws InputException with file and line, if it is not as it should be
     */
    public static SeedFile read(Path file) {
        try {
            if (Files.isDirectory(file)) {
                throw new InputException(file + ": found a folder, expected a file of seeds");
            }
            try (InputStream in = Files.newInputStream(file)) {
                byte[] bytes = in.readNBytes(MOST_BYTES + 1);
                if (bytes.length > MOST_BYTES) {
                    throw new InputException(file + ": found a file of more than " + MOST_BYTES
                        + " bytes, expected no larger one");
                }
                return read(Utf8Text.decode(bytes, file.toString(), "a text in UTF-8"), file.toString());
            }
        } catch (NotUtf8Exception problem) {
            throw new InputException(problem.getMessage());
        } catch (IOException problem) {
            throw new InputException(file + ": cannot be read: " + (Files.exists(file)
                ? OutputFiles.reason(file, problem) : "there is no such file"));
        }
    }

    /** Reads a text. @param source how errors name it */
    static SeedFile read(String text, String source) {
        Map<Long, Integer> seeds = new LinkedHashMap<>();
        Map<String, String> choosers = new LinkedHashMap<>();
        List<String> lines = (text.startsWith(BYTE_ORDER_MARK) ? text.substring(1) : text).lines().toList();
        for (int k = 0; k < lines.size(); k++) {
            Matcher chooser = CHOOSER.matcher(lines.get(k).strip());
            if (chooser.matches()) {
                choosers.put(chooser.group(1), chooser.group(2));
            }
            int comment = lines.get(k).indexOf('#');
            String word = (comment < 0 ? lines.get(k) : lines.get(k).substring(0, comment)).strip();
            if (!word.isEmpty()) {
                add(seeds, word, k + 1, source + ":" + (k + 1) + ": found ");
            }
        }
        if (seeds.isEmpty()) {
            throw new InputException(source + ": found no seed, expected one a line");
        }
        return new SeedFile(source, text, Seeds.of(new ArrayList<>(seeds.keySet())), choosers);
    }

    private static void add(Map<Long, Integer> seeds, String word, int line, String found) {
        Integer before;
        try {
            before = seeds.putIfAbsent(Long.valueOf(word), line);
        } catch (NumberFormatException other) {
            throw new InputException(found + "'" + TextFormat.plain(TextFormat.beginning(word, SHOWN))
                + "', expected a seed, a whole number of 64 bits, and behind # a comment");
        }
        if (before != null) {
            throw new InputException(found + "the seed " + word + " a second time, expected each once; it stands in "
                + "line " + before + ", too");
        }
    }
}
