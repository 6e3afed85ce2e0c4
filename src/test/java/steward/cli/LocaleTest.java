package steward.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.bot.command.CommandLine;
import steward.bot.command.ProgramFinder;
import steward.cli.streams.Streams;
import steward.codingame.recording.OfficialGame;

/**
 * The program without a locale, as cron starts it, where folders and files have other letters than those of ASCII. It
 * takes long because every command is called, and each game starts its bots.
 */
@Tag("process")
@Tag("slow")
@Execution(ExecutionMode.CONCURRENT)
class LocaleTest {

    private static final String BOT = "#!/bin/sh\necho \"locale ${LC_ALL-none}\" >&2\nread -r setup\nwhile read -r l; "
        + "do echo '{\"pods\":[{\"x\":1,\"y\":1,\"thrust\":0}]}'; done\n";

    /** A call: its exit status, its words as a shell reads them, and a part of what it says. */
    private record Call(int status, String words, String says) { }

    private static final String JOSE = "'José=sh José.sh'";
    /** A name of the table whose accents have become something else. */
    private static final Pattern BROKEN = Pattern.compile("Jos[?Ã]|Zo[?Ã]|\\b(Liga|Klasse) [?Ã]"
        + "|[?Ã]and|\\bd[?Ã]+\\.json");

    /** A call of every command, in one folder one after the other. */
    private static final List<Call> CALLS = List.of(
        new Call(0, "doctor", "names of files      UTF-8 by LC_ALL="),
        new Call(0, "help match", "--bot"),
        new Call(0, "completion", "steward"),
        new Call(0, "new python Zoë", "Zoë"),
        new Call(2, "scene dé.json", "dé.json: found no scene of this name"),
        new Call(0, "explain dé.json", "dé"),
        new Call(0, "check 'sh José.sh' --scene dé.json", "José.sh"),
        new Call(0, "match --scene dé.json --bot " + JOSE + " --bot builtin:racer --seed 3 --out é.jsonl", "José"),
        new Call(0, "match --scene dé.json --bot 'java -cp . Nobody' --bot builtin:racer", "set LC_ALL=C.UTF-8"),
        new Call(0, "replay é.jsonl --view é.html", "é.html"),
        new Call(0, "replay é.jsonl --turn 2", "José"),
        new Call(0, "feed é.jsonl --player 0 'sh José.sh'", "José"),
        new Call(0, "run bowl --turns 3 --out bówl.jsonl", "bówl.jsonl"),
        new Call(0, "simulate --scene mäd.json", ""),
        new Call(0, "demo --out dèmo.jsonl", "dèmo.jsonl"),
        new Call(0, "sprt --scene dé.json --bot " + JOSE + " --bot 'Zoë=sh José.sh 2' --games 2", "Zoë"),
        new Call(0, "seeds --scene dé.json --bot " + JOSE + " --bot builtin:racer --count 1 --from 2", "José"),
        new Call(2, "tune --scene dé.json --bot 'José=sh José.sh {a:1|2}' --against ./ñ --games 100", "./ñ"),
        new Call(0, "tournament 'Klasse é' --protocol json --games 2 --scene dé.json --page 'Seité'", "Ñandú"),
        new Call(0, "league games 'Seité/league' --failed", "no such games"),
        new Call(0, "key new kéy", "kéy"),
        new Call(0, "import gäme.json --out ïmport.jsonl", "ïmport.jsonl"),
        new Call(0, "referee -scene dé.json -p1 'json:sh José.sh' -p2 builtin:racer -r ré.jsonl -l lé.json", ""),
        new Call(0, "play --json-league 'json:sh José.sh' builtin:racer --scene dé.json --out plé.jsonl", ""),
        new Call(0, "resident --socket söcket/s --idle 1s", ""),
        new Call(2, "tradeoff --scene 'nié.json'", "nié.json"),
        new Call(2, "bench --quick --only främe", "främe"),
        new Call(2, "adopt Projékt --as game", "Projékt"),
        new Call(2, "worker --join localhost:9 --token-file tökén", "tökén"),
        new Call(0, "league init 'Liga é' --scene dé.json", "Liga é"),
        new Call(0, "league add 'Liga é' " + JOSE + " builtin:racer --random", "José"),
        new Call(0, "league list 'Liga é'", "José"),
        new Call(0, "league run 'Liga é' --games 4", "José"),
        new Call(0, "league table 'Liga é'", "José"),
        new Call(0, "league table 'Liga é' --json", "José"),
        new Call(0, "league games 'Liga é'", "José"),
        new Call(0, "league why 'Liga é' José", "José"),
        new Call(0, "league page 'Liga é' --out Lé.html", "Lé.html"),
        new Call(0, "league export 'Liga é' --out spïele.jsonl", ""),
        new Call(0, "league import 'Liga é' spïele.jsonl", ""),
        new Call(0, "league backup 'Liga é' kopïe.db", "kopïe.db"),
        new Call(0, "league verify 'Liga é'", ""),
        new Call(2, "league sprt 'Liga é' José Ñandú", "Ñandú"),
        new Call(0, "league retire 'Liga é' José", "José"),
        new Call(0, "league retire 'Liga é' José --back", "José"),
        new Call(0, "league resume 'Liga é' José", "José"),
        new Call(0, "league forgive 'Liga é' José --games 1..1", "José"),
        new Call(0, "league rename 'Liga é' José Zoë", "Zoë"),
        new Call(0, "league worker add 'Liga é' laptop --out Notebook-é.token", "Notebook-é.token"),
        new Call(0, "league worker list 'Liga é'", "laptop"),
        new Call(0, "league prune 'Liga é' --keep none", ""));

    @TempDir
    private Path folder;
    private Path place;
    private Path launcher;

    /** An installation of the launcher around the classes of the tests. */
    @BeforeEach
    void install() throws IOException {
        assumeTrue(ShellBots.runnable() && ProgramFinder.find("locale") != null, "there is no /bin/sh or no locale");
        Path home = folder.resolve("Installation für é");
        Path lib = Files.createDirectories(home.resolve("lib"));
        List<String> classes = new ArrayList<>();
        for (String each : System.getProperty("java.class.path").split(":")) {
            classes.add(Files.createSymbolicLink(lib.resolve(classes.size() + ""), Path.of(each).toAbsolutePath())
                .toString());
        }
        launcher = Files.createDirectories(home.resolve("bin")).resolve("steward");
        Files.writeString(launcher, Files.readString(Path.of("src/launcher/steward"))
            .replace("classes=@CLASSPATH@", "classes='" + String.join(":", classes) + "'"));
        place = Files.createDirectories(folder.resolve("ä 日本"));
        Files.writeString(place.resolve("José.sh"), BOT);
        Files.writeString(place.resolve("dé.json"), Cli.run("scene", "duel").out().replace("\"duel\"", "\"dé\"")
            .replace("\"maximumTurns\": 200", "\"maximumTurns\": 20"));
    }

    @AfterEach
    void removeLinks() throws IOException {
        try (Stream<Path> links = Files.list(launcher.resolveSibling("../lib"))) {
            for (Path link : links.toList()) {
                Files.delete(link);
            }
        }
    }

    /** Output of both streams of a call. */
    private String call(int status, Map<String, String> locale, String... words)
            throws IOException, InterruptedException {
        List<String> command = new ArrayList<>(List.of("/bin/sh", launcher.toString()));
        command.addAll(List.of(words));
        ProcessBuilder builder = new ProcessBuilder(command).directory(place.toFile()).redirectErrorStream(true);
        builder.environment().keySet().retainAll(List.of("PATH"));
        builder.environment().put("JAVA_HOME", System.getProperty("java.home"));
        builder.environment().put("XDG_CACHE_HOME", folder.resolve("cache").toString());
        builder.environment().putAll(locale);
        Process process = builder.start();
        process.getOutputStream().close();
        String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertEquals(status, process.waitFor(), String.join(" ", words) + ":\n" + said);
        assertFalse(said.contains("\uFFFD") || said.contains("should not have happened"), said);
        return said;
    }

    @Test
    void aMatchOfABotAndASceneWithAccentsIsPlayedAndTheBotsLocaleIsItsOwn() throws IOException, InterruptedException {
        String bot = "sh José.sh";
        for (Map<String, String> locale : List.of(Map.<String, String>of(), Map.of("LC_ALL", "C"),
                Map.of("LANG", "xx_YY.UTF-8"))) {
            call(0, locale, "match", "--scene", "dé.json", "--bot", bot, "--bot", "builtin:racer", "--seed", "3",
                "--out", "é.jsonl", "--sandbox", "off", "--no-deadline");
            String replay = Files.readString(place.resolve("é.jsonl"));
            assertTrue(replay.contains("locale " + locale.getOrDefault("LC_ALL", "none") + "\\n"), replay);
            Files.delete(place.resolve("é.jsonl"));
        }
    }

    /** All calls in one JVM that the launcher has started. */
    @Test
    void everyCommandReadsWritesAndNamesWithAccents() throws IOException, InterruptedException {
        files();
        Files.writeString(launcher, Files.readString(launcher)
            .replace("steward.cli.Main \"$@\"", "steward.cli.SeveralCalls \"$@\""));
        List<List<String>> words = CALLS.stream().map(each -> CommandLine.split(each.words)).toList();
        String rest = call(0, Map.of(), SeveralCalls.words(words).toArray(String[]::new));
        for (int k = 0; k < CALLS.size(); k++) {
            String end = SeveralCalls.line(CALLS.get(k).status, words.get(k)) + "\n";
            int at = rest.indexOf(end);
            assertTrue(at >= 0, CALLS.get(k).words + ":\n" + rest);
            assertWhole(CALLS.get(k), rest.substring(0, at));
            rest = rest.substring(at + end.length());
        }
        assertNamesOfFiles();
    }

    /** Each in a process of its own, and a worker that plays for a league. */
    @Test
    @Tag("campaign")
    void everyCommandDoesSoInAProcessOfItsOwn() throws IOException, InterruptedException {
        files();
        for (Call each : CALLS) {
            assertWhole(each, call(each.status, Map.of(), CommandLine.split(each.words).toArray(String[]::new)));
        }
        assertNamesOfFiles();
        call(0, Map.of("LC_ALL", "C.UTF-8"), "league", "run", "Liga é", "--games", "6", "--quiet");
        String table = call(0, Map.of(), "league", "table", "Liga é");
        assertTrue(table.contains("Zoë") && !table.contains("Zoë#"), "a version for all locales:\n" + table);
    }

    @Test
    void theTableHasEveryCommand() {
        List<String> missing = new ArrayList<>(Main.commands());
        missing.remove("league");
        Main.program(Streams.standard(), "league").getSubcommands().get("league").getSubcommands().keySet().stream()
            .forEach(each -> missing.add("league " + each));
        missing.removeIf(each -> CALLS.stream().anyMatch(call -> (call.words + " ").startsWith(each + " ")));
        assertEquals(List.of(), missing);
    }

    private void files() throws IOException {
        Files.writeString(place.resolve("mäd.json"), Cli.run("scene", "mad-pod-racing").out());
        Files.writeString(place.resolve("gäme.json"), OfficialGame.play(12).json());
        Files.createDirectory(place.resolve("söcket"), PosixFilePermissions.asFileAttribute(
            PosixFilePermissions.fromString("rwx------")));
        Path starter = place.resolve("stärter");
        Cli.run("new", "python", starter.toString()).done();
        Cli.run("new", "java", place.resolve("jäva").toString(), "--protocol", "json").done();
        Files.createDirectories(place.resolve("Klasse é"));
        Files.copy(place.resolve("jäva/Bot.java"), place.resolve("Klasse é/Zdeněk.java"));
        for (String name : List.of("Zoë.py", "Ñandú.py")) {
            Files.copy(starter.resolve("bot.py"), place.resolve("Klasse é").resolve(name));
        }
    }

    /** Nothing of what a call said is broken, and it has said what it should. */
    private static void assertWhole(Call call, String said) {
        assertTrue(said.contains(call.says), call.words + ":\n" + said);
        assertFalse(said.contains("\uFFFD") || said.contains("should not have happened")
            || said.contains("cannot run"), call.words + ":\n" + said);
        assertFalse(BROKEN.matcher(said).find(), call.words + ":\n" + said);
    }

    private void assertNamesOfFiles() throws IOException {
        List<String> wrong = new ArrayList<>();
        try (Stream<Path> all = Files.walk(place)) {
            for (Path each : all.toList()) {
                String name = each.toString();
                boolean text = name.matches(".*\\.(json|jsonl|html|csv|txt|md|token)") && Files.isRegularFile(each);
                String content = text ? Files.readString(each) : "";
                if (name.contains("?") || name.contains("\uFFFD") || BROKEN.matcher(content).find()) {
                    wrong.add(name);
                }
            }
        }
        assertEquals(List.of(), wrong);
    }
}
