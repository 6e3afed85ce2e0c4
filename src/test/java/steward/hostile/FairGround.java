package steward.hostile;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import java.util.stream.StreamSupport;
import steward.bot.hold.HoldPolicy;
import steward.bot.isolation.HoldMeans;
import steward.bot.isolation.Isolation;
import steward.bot.isolation.SandboxLevel;
import steward.bot.isolation.SandboxSupport;
import steward.cli.Cli;
import steward.text.EnumWords;
import tools.jackson.databind.JsonNode;

/**
 * Plays bots that burn processors against one that searches 50 of its 75 ms, many games of each case, and prints a row
 * of a table for each: how many games the searching bot lost on time in the end, how many were played again, and in how
 * many the other was held. The case {@code none} is the baseline: the same bot without what burns.
 *
 * <p>{@code --games N} of each case (50), {@code --only WORD,WORD} cases, {@code chains} for all of those,
 * {@code --levels light,strict}, {@code --time wall,cpu}, {@code --hold burners}, {@code --threads 1}, {@code --turns
 * N} of a game (30), {@code --load N} busy processes beside it all. Exit status 1 if a case loses more games than the
 * baseline of its level and time.
 */
public final class FairGround {

    private static final List<String> CASES = List.of("none", "hogs", "many", "forks", "sigcont", "pulse", "sleeper",
        "memory", "namespaces", "timer", "own");
    /** Chains of processes, 1, 4 or 16, each process for so many milliseconds; of those that are lost nobody waits. */
    private static final List<String> CHAINS = Stream.of("chain", "lost").flatMap(kind -> Stream.of(1, 4, 16)
        .flatMap(chains -> Stream.of(1, 2, 5, 20).map(ms -> kind + "-" + chains + "-" + ms))).toList();
    private static final String ROW = "%-11s %-7s %-5s %6s %12s %12s %6s %14s %8s%n";
    private static final String SEARCH_MS = "50";
    /** Seeds, each played from both sides. */
    private static final int ROUND = 5;

    private final List<String> options;
    private final Path work;

    private FairGround(List<String> options, Path work) {
        this.options = options;
        this.work = work;
    }

    private record Row(int games, int lost, int again, int held, int uncounted, double seconds) {

        Row and(Row other) {
            return new Row(games + other.games, lost + other.lost, again + other.again, held + other.held,
                uncounted + other.uncounted, seconds + other.seconds);
        }
    }

    /** Reads the options, plays, prints. */
    public static void main(String[] arguments) throws IOException, InterruptedException {
        Path work = Files.createTempDirectory(Path.of(System.getProperty("java.io.tmpdir")), "fair-");
        FairGround ground = new FairGround(List.of(arguments), work);
        List<Process> load = ground.load();
        boolean fair = false;
        try {
            fair = ground.play();
        } finally {
            load.forEach(Process::destroyForcibly);
        }
        System.exit(fair ? 0 : 1);
    }

    private String option(String name, String usual) {
        int at = options.indexOf("--" + name);
        return at < 0 ? usual : options.get(at + 1);
    }

    private List<Process> load() throws IOException {
        List<Process> load = new ArrayList<>();
        for (int k = 0; k < Integer.parseInt(option("load", "0")); k++) {
            load.add(new ProcessBuilder("sh", "-c", "while :; do :; done").start());
        }
        return load;
    }

    private boolean play() throws IOException, InterruptedException {
        Path scene = scene();
        for (String folder : List.of("hog", "honest")) {
            Path program = Files.createDirectories(work.resolve(folder)).resolve(folder);
            if (new ProcessBuilder("cc", "-O1", "-o", program.toString(), "src/test/hostile/hog.c").inheritIO().start()
                    .waitFor() != 0) {
                System.out.println("skipped: there is no C compiler (cc)");
                return false;
            }
        }
        boolean fair = true;
        System.out.println("user " + System.getProperty("user.name") + ", "
            + Runtime.getRuntime().availableProcessors() + " processors, " + option("load", "0")
            + " busy processes beside; hold " + option("hold", "burners") + ", threads " + option("threads", "1"));
        System.out.printf(ROW, "case", "level", "time", "games", "lost on time", "played again", "held",
            "without result", "seconds");
        for (String level : option("levels", "light,strict").split(",")) {
            SandboxLevel sandbox = SandboxLevel.valueOf(level.toUpperCase(Locale.ROOT));
            if (SandboxSupport.problem(sandbox) != null) {
                System.out.println("level " + level + " does not work here: " + SandboxSupport.problem(sandbox));
                continue;
            }
            HoldPolicy policy = EnumWords.find(List.of(HoldPolicy.values()),
                option("hold", "burners")).orElseThrow();
            System.out.println("at " + level + ", bots that burn are "
                + HoldMeans.of(Isolation.at(sandbox).holding(policy)).text());
            for (String time : option("time", "wall").split(",")) {
                fair &= isFair(scene, level, time);
            }
        }
        return fair;
    }

    /** Cases take turns in rounds, so that all of them see the same machine. */
    private boolean isFair(Path scene, String level, String time) {
        List<String> words = List.of(option("only", String.join(",", CASES)).replace("chains",
            String.join(",", CHAINS)).split(","));
        Row[] rows = new Row[words.size()];
        Arrays.fill(rows, new Row(0, 0, 0, 0, 0, 0));
        int seeds = Math.max(1, Integer.parseInt(option("games", "50")) / 2);
        for (int first = 1; first <= seeds; first += ROUND) {
            for (int k = 0; k < rows.length; k++) {
                rows[k] = rows[k].and(row(scene, words.get(k), level, time, first, Math.min(ROUND, seeds + 1 - first)));
            }
        }
        int baseline = words.contains("none") ? rows[words.indexOf("none")].lost() : 0;
        boolean fair = true;
        for (int k = 0; k < rows.length; k++) {
            Row row = rows[k];
            System.out.printf(ROW, words.get(k), level, time, row.games(), row.lost(), row.again(), row.held(),
                row.uncounted(), String.format(Locale.ROOT, "%.0f", row.seconds()));
            fair &= row.lost() <= baseline;
        }
        return fair;
    }

    /** Sides take turns: who is asked first in a turn may matter. */
    private Row row(Path scene, String word, String level, String time, int first, int seeds) {
        long begun = System.nanoTime();
        JsonNode result = Cli.run("match", "--scene", scene.toString(), "--games",
            "" + seeds, "--swap", "--seed", "" + first, "--sandbox", level, "--time", time, "--hold",
            option("hold", "burners"), "--threads", option("threads", "1"), "--json", "--bot",
            "hog=" + work.resolve("hog/hog") + " " + word + " " + (word.equals("own") ? SEARCH_MS : "0"), "--bot",
            "honest=" + work.resolve("honest/honest") + " none " + SEARCH_MS).json();
        int held = (int) StreamSupport.stream(result.path("list").spliterator(), false).filter(FairGround::isHeld)
            .count();
        return new Row(result.path("games").asInt(), result.path("bots").path(1).path("faults").asInt(),
            result.path("playedAgain").asInt(), held, result.path("games").asInt() - result.path("results").asInt(),
            (System.nanoTime() - begun) / 1e9);
    }

    private static boolean isHeld(JsonNode game) {
        return StreamSupport.stream(game.path("heldFrom").spliterator(), false).anyMatch(turn -> turn.asInt(0) > 0);
    }

    /** The short duel with few turns. */
    private Path scene() throws IOException {
        String text = Files.readString(Path.of("config/scenes/duel.json")).replace("\"name\": \"duel\"",
            "\"name\": \"fair\"").replace("\"maximumTurns\": 200", "\"maximumTurns\": " + option("turns", "30"));
        return Files.writeString(work.resolve("fair.json"), text);
    }
}
