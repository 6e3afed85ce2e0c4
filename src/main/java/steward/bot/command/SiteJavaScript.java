package steward.bot.command;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import steward.files.Resources;

/**
 * Call of Node.js for a bot written for CodinGame's site, where {@code readline}, {@code print} and {@code printErr}
 * exist. A text before the bot defines them; it needs no file, which a sandbox would have to show.
 */
public final class SiteJavaScript {

    private static final Set<String> PROGRAMS = Set.of("node", "nodejs");
    private static final String BEFORE = "/steward/codingame/site.js";

    private SiteJavaScript() { }

    /** The command with these functions, if it is {@code node FILE}, and otherwise as it is: options may be any. */
    public static List<String> words(List<String> words) {
        if (words.size() < 2 || words.get(1).startsWith("-")
            || !PROGRAMS.contains(words.get(0).substring(words.get(0).lastIndexOf('/') + 1))) {
            return words;
        }
        List<String> extended = new ArrayList<>(List.of(words.get(0), "-e", Resources.text(BEFORE)));
        extended.addAll(words.subList(1, words.size()));
        return extended;
    }
}
