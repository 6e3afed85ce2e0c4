package steward.bot.process;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import steward.bot.command.Program;
import steward.bot.command.ProgramFinder;
import steward.bot.command.ProgramTrial;
import steward.bot.isolation.Isolation;
import steward.bot.isolation.Launch;
import steward.bot.isolation.MissingFiles;
import steward.bot.isolation.SandboxLevel;

/** Files that bots at strict see, wherever bots, leagues and interpreters are. */
@Tag("process")
class StrictFilesTest {

    /** Says which of the files that it is named it can read; the rest is to be empty. */
    private static final String SPY = "read -r l; for f in \"$@\"; do [ \"$(cat \"$f\" 2>/dev/null)\" = secret ] && "
        + "printf '%s ' \"${f##*/}\"; done; echo .; read -r l";

    @TempDir
    private Path folder;

    @BeforeEach
    void strictWorks() {
        ScriptedBots.assumeWorks(SandboxLevel.STRICT);
    }

    private static String said(List<String> command, List<Program> others, Isolation isolation) {
        try (BotProcess bot = new BotProcess("bot", new Launch(command, isolation, others), 0)) {
            return ScriptedBots.reply(bot, "go\n");
        }
    }

    private static Path write(Path file, String text) throws IOException {
        Files.createDirectories(file.getParent());
        return Files.writeString(file, text);
    }

    /**
     * A tournament of strangers: folder, league, keys, the bot of another entrant who does not play now, a file beside
     * them. Places where this user may not write are left out. Folders of the system's libraries are seen, and in them
     * what is not of the league.
     */
    @ParameterizedTest
    @ValueSource(strings = {"/srv", "/var/tmp", "/tmp", "/etc", "/usr/local/src", "/usr/lib", "HOME", "/"})
    void aBotInTheFolderOfALeagueSeesOnlyItself(String place) throws IOException {
        assertItSeesOnlyItself(place);
    }

    @Tag("campaign")
    @ParameterizedTest
    @ValueSource(strings = {"/opt", "/home", "/var/lib", "/mnt", "/media", "/usr/share", "/usr/local/lib",
        "/usr/local/share"})
    void aBotInTheFolderOfALeagueSeesOnlyItselfElsewhereToo(String place) throws IOException {
        assertItSeesOnlyItself(place);
    }

    private static void assertItSeesOnlyItself(String place) throws IOException {
        Path root = Path.of(place.equals("HOME") ? System.getProperty("user.home") : place);
        assumeTrue(Files.isWritable(root), "skipped: this user may not write into " + root);
        Path top = Files.createTempDirectory(root, "steward-test-");
        try {
            Path league = top.resolve("night");
            List<Path> files = new ArrayList<>();
            for (String each : List.of("night/league.json", "night/league.db", "night/machines/broker.p12",
                    "night/replays/1.jsonl", "night/bots/other/bot.sh", "night/bots/third.sh", "beside", "w1.token")) {
                files.add(write(top.resolve(each), "secret"));
            }
            Path own = write(league.resolve("bots/mine/own"), "secret");
            files.add(own);
            for (Path script : List.of(own.resolveSibling("bot.sh"), league.resolve("bots/bot.sh"),
                    league.resolve("bot.sh"))) {
                List<String> command = new ArrayList<>(List.of("sh", write(script, SPY).toString()));
                Isolation isolation = Isolation.at(SandboxLevel.STRICT).hiding(List.of(league))
                    .hidingFilesOf(List.of(Program.here(List.of("sh", league.resolve("bots/third.sh").toString()))));
                List<Program> others = List.of(
                    Program.here(List.of("sh", league.resolve("bots/other/bot.sh").toString())));
                command.add("/" + files.stream().map(Path::toString).reduce((a, b) -> a + " /" + b).orElseThrow());
                // In one word, so that no path of it belongs to the bot by being named.
                Files.writeString(script, "set -f; set -- $1; " + SPY);
                boolean sharing = !script.startsWith(own.getParent()) && script.getParent().equals(
                    league.resolve("bots"));
                assertEquals((place.startsWith("/usr/") && !place.endsWith("src") ? "beside w1.token " : "")
                    + (script.startsWith(own.getParent()) || sharing ? "own ." : "."),
                    said(command, others, isolation), script.toString());
            }
        } finally {
            try (Stream<Path> all = Files.walk(top)) {
                all.sorted(Comparator.reverseOrder()).forEach(file -> file.toFile().delete());
            }
        }
    }

    /**
     * Home, the private folder for temporary files, and nothing of what machines keep elsewhere. Of the way down to the
     * folder where the referee runs, a bot sees the names.
     */
    @Test
    void whatIsNoProgramIsEmptyOrNotThere() throws IOException {
        Path here = Path.of("").toRealPath();
        List<String> empty = List.of(System.getProperty("user.home"), "/tmp", "/dev/shm");
        List<String> absent = List.of("/var", "/opt", "/srv", "/mnt", "/sys", "/boot", "/root/.ssh", "/etc/shadow",
            "/etc/ssl/private", "/usr/src", "/usr/local/src");
        String script = "read -r l; for d in \"$HOME\" /tmp /dev/shm; do echo $(ls -A \"$d\"); done | tr '\\n' ';';"
            + " ls -d " + String.join(" ", absent) + " 2>/dev/null | tr '\\n' ' ';"
            + " for d in / \"$HOME\" /usr /etc /run /var; do echo x 2>/dev/null >\"$d/x\" && echo wrote; done; echo .;"
            + " read -r l";
        String expected = empty.stream().map(Path::of).map(place -> nameOnTheWay(place, here) + ";")
            .collect(Collectors.joining()) + absent.stream().filter(here::startsWith).map(place -> place + " ")
            .collect(Collectors.joining()) + ".";
        assertEquals(expected, said(List.of("/bin/sh", "-c", script), List.of(), Isolation.at(SandboxLevel.STRICT)));
    }

    private static String nameOnTheWay(Path place, Path here) {
        return here.startsWith(place) && !here.equals(place) ? here.getName(place.getNameCount()).toString() : "";
    }

    /** Interpreters as their users install them: in a virtual environment, by a link, as a copy. */
    @Test
    @Tag("slow")
    void virtualEnvironmentsStart() throws Exception {
        assumeTrue(ProgramFinder.find("python3") != null, "skipped: there is no python3");
        Path script = write(folder.resolve("mine/bot.py"),
            "import json, ssl, sys\ninput()\nprint(sys.prefix)\ninput()\n");
        for (String kind : List.of("--symlinks", "--copies")) {
            Path environment = folder.resolve("venv" + kind);
            assumeTrue(ProgramTrial.of(List.of("python3", "-m", "venv", "--without-pip", kind, environment.toString()),
                60_000).works(), "skipped: this python3 makes no virtual environments");
            assertEquals(environment.toString(), said(List.of(environment.resolve("bin/python").toString(),
                script.toString()), List.of(), Isolation.at(SandboxLevel.STRICT)));
            deleteLinks(environment.resolve("bin"));
        }
    }

    /** The folder of a test warns of links that lead out of it. */
    private static void deleteLinks(Path folder) throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            for (Path file : files.filter(Files::isSymbolicLink).toList()) {
                Files.delete(file);
            }
        }
    }

    /** Java through a link, as version managers have it, with the certificates and settings of the system. */
    @Test
    @Tag("slow")
    @Tag("campaign")
    void javaStartsThroughALink() throws IOException {
        Path link = Files.createSymbolicLink(folder.resolve("current"), Path.of(System.getProperty("java.home")));
        Path source = write(folder.resolve("mine/Bot.java"), "public class Bot { public static void main(String[] a)"
            + " throws Exception { javax.net.ssl.SSLContext.getDefault(); System.in.read();"
            + " System.out.println(\"runs\"); System.in.read(); } }");
        assumeTrue(Files.exists(link.resolve("bin/javac")), "skipped: this Java compiles nothing");
        assertEquals("runs", said(List.of(link.resolve("bin/java").toString(), source.toString()), List.of(),
            Isolation.at(SandboxLevel.STRICT)));
        Files.delete(link);
    }

    @Test
    void aPathThatABotLackedIsNamed() throws IOException {
        Path data = write(folder.resolve("data/book.txt"), "x");
        Path program = write(folder.resolve("jdk/bin/java"), "");
        assertTrue(program.toFile().setExecutable(true));
        Path module = write(folder.resolve("project/node_modules/left-pad/index.js"), "");
        String bot = write(folder.resolve("project/dist/bot.js"), "").toString();
        Isolation strict = Isolation.at(SandboxLevel.STRICT);
        List<String> command = List.of("/bin/sh", bot);
        assertEquals(List.of(data), MissingFiles.of(Program.here(command),
            List.of("cannot open '" + data + "': No such file"), strict));
        assertEquals(List.of(folder.resolve("jdk")), MissingFiles.of(Program.here(command),
            List.of("sh: 1: exec: " + program + ": not found"), strict));
        assertEquals(List.of(module.getParent().getParent()), MissingFiles.of(Program.here(command),
            List.of("Error: Cannot find module 'left-pad'"), strict));
        assertEquals(List.of(), MissingFiles.of(Program.here(command),
            List.of("/usr: /tmp /bin/sh " + bot + " " + folder + "/no/file"), strict));
        assertEquals(List.of(data.getParent()), MissingFiles.of(Program.here(command),
            List.of("no luck in " + data.getParent()), strict));
    }
}
