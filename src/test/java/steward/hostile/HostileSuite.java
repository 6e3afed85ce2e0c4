package steward.hostile;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDate;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import steward.bot.isolation.SandboxLevel;
import steward.bot.isolation.SandboxSupport;
import steward.hostile.HostileTrial.Finding;
import steward.text.TextFormat;

/**
 * Plays every hostile bot at every level of isolation that works here, and prints what became of it: {@code held},
 * {@code escapes} or {@code succeeds}, and after how many milliseconds the match was over. With {@code --markdown FILE}
 * the tables of {@code docs/tables/attacks.md} and the day are written. Exit status 1 if anything is not as expected.
 *
 * <p>{@code --often} plays the attacks of the campaigns and leaves out those on files, pages and leagues; {@code
 * --short} plays every other of them at one level alone, in turn; {@code --only guards} plays those left out, {@code
 * --only WORD} those of this word.
 */
public final class HostileSuite {

    private static final String ROW = "%-55s %-14s %-14s %-14s %s%n";

    private HostileSuite() {
    }

    /** Reads the options, plays, prints. */
    public static void main(String[] arguments) throws IOException, InterruptedException {
        List<String> options = List.of(arguments);
        Path temporary = Path.of(System.getProperty("java.io.tmpdir"));
        Path work = Files.createTempDirectory(temporary, "hostile-");
        List<String> problems = new ArrayList<>();
        List<String> rows = new ArrayList<>();
        Programs programs = new Programs(work);
        HostileTrial trial = new HostileTrial(programs, work);
        Map<SandboxLevel, String> next = new EnumMap<>(SandboxLevel.class);
        for (SandboxLevel level : SandboxLevel.values()) {
            String problem = SandboxSupport.problem(level);
            if (problem != null) {
                System.out.println("level " + level.word() + " is skipped: it does not work here: " + problem);
                continue;
            }
            next.put(level, trial.undisturbed(level));
        }
        List<SandboxLevel> levels = List.copyOf(next.keySet());
        System.out.printf(ROW, "a bot", "off", "light", "strict", "verdict");
        for (Attack attack : chosen(options)) {
            SandboxLevel only = options.contains("--short") ? levels.get(rows.size() % levels.size()) : null;
            if (!programs.has(attack)) {
                System.out.println(attack.what() + ": skipped, there is no C compiler (cc)");
                continue;
            }
            rows.add(row(trial, attack, only, next, problems));
        }
        int attacks = rows.size();
        int named = options.indexOf("--only");
        if (named >= 0 ? options.get(named + 1).equals("guards") : !isShort(options)) {
            guards(new Guards(Files.createDirectory(work.resolve("guards"))).run(), rows, problems);
        }
        String day = "Printed on " + LocalDate.now() + ".";
        System.out.println(day);
        int markdown = options.indexOf("--markdown");
        if (markdown >= 0) {
            rows.add(day);
            Files.write(Path.of(options.get(markdown + 1)), rows);
        }
        problems.forEach(problem -> System.out.println("PROBLEM: " + problem));
        System.out.println(attacks + " attacks at " + next.size() + " levels, " + problems.size() + " problems");
        System.exit(problems.isEmpty() ? 0 : 1);
    }

    private static void guards(Map<String, String> found, List<String> rows, List<String> problems) {
        found.forEach((what, became) -> {
            System.out.printf("%-70s %s%n", what, became);
            rows.add("| " + what + " | " + became + " |");
            if (!became.startsWith("held")) {
                problems.add(what + ": " + became);
            }
        });
    }

    private static List<Attack> chosen(List<String> options) {
        int only = options.indexOf("--only");
        List<Attack> all = Attacks.ALL.stream().filter(attack -> only >= 0 ? attack.word().equals(options.get(only + 1))
            : attack.shortRun() || !isShort(options)).toList();
        return options.contains("--short") ? all.stream().filter(attack -> all.indexOf(attack) % 2 == 0).toList() : all;
    }

    private static boolean isShort(List<String> options) {
        return options.contains("--short") || options.contains("--often");
    }

    /** @param only the level at which it is played; {@code null} for all that work here */
    private static String row(HostileTrial trial, Attack attack, SandboxLevel only, Map<SandboxLevel, String> next,
                              List<String> problems) throws IOException, InterruptedException {
        String[] cells = {"-", "-", "-"};
        StringBuilder markdown = new StringBuilder("| " + attack.what() + " |");
        String verdict = "";
        for (SandboxLevel level : SandboxLevel.values()) {
            if (!next.containsKey(level) || only != null && level != only) {
                markdown.append(" - |");
                continue;
            }
            Finding finding = trial.play(attack, level);
            String where = attack.what() + ", " + level.word() + ": ";
            finding.problems().forEach(problem -> problems.add(where + problem));
            String after = trial.undisturbed(level);
            if (!after.equals(next.get(level))) {
                problems.add(where + "the next match is another one: " + after + ", not " + next.get(level));
            }
            cells[level.ordinal()] = finding.effect().word() + ", " + finding.millis() + " ms";
            markdown.append(' ').append(finding.effect().word()).append(" |");
            verdict = finding.verdict();
        }
        System.out.printf(ROW, attack.what(), cells[0], cells[1], cells[2], TextFormat.shorten(verdict, 70));
        return markdown.toString();
    }
}
