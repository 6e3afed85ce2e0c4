package steward.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import steward.bot.command.CommandLine;
import steward.bot.command.ProgramFinder;

/** The program without a locale, as cron starts it, where folders and files have other letters than those of ASCII. */
@Tag("process")
@Tag("slow")
class LocaleTest {

    private static final String BOT = "#!/bin/sh\necho \"locale ${LC_ALL-none}\" >&2\nread -r setup\nwhile read -r l; "
        + "do echo '{\"pods\":[{\"x\":1,\"y\":1,\"thrust\":0}]}'; done\n";

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
        Files.writeString(place.resolve("dé.json"), Cli.run("scene", "duel").out().replace("\"duel\"", "\"dé\""));
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

    private String call(String... words) throws IOException, InterruptedException {
        return call(0, Map.of(), words);
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

    @Test
    @Tag("campaign")
    void everyCommandNamesItsFiles() throws IOException, InterruptedException {
        String bot = "sh José.sh";
        String doctor = call("doctor");
        assertTrue(doctor.contains("names of files      UTF-8 by LC_ALL="), doctor);
        call("new", "python", "Zoë");
        call(0, Map.of("LC_ALL", "POSIX"), "check", bot, "--scene", "dé.json");
        call("match", "--scene", "dé.json", "--bot", bot, "--bot", "builtin:racer", "--seed", "3", "--out", "é.jsonl");
        for (String[] more : new String[][] {{"--verify"}, {"--view", "é.html"}, {"--turn", "2"},
                {"--frames", "--player", "0"}}) {
            call(Stream.concat(Stream.of("replay", "é.jsonl"), Stream.of(more)).toArray(String[]::new));
        }
        assertTrue(Files.isRegularFile(place.resolve("é.html")));
        call("feed", "é.jsonl", "--player", "0", bot);
        call("explain", "dé.json");
        call("run", "bowl", "--turns", "3", "--out", "bówl.jsonl");
        call("demo", "--out", "dèmo.jsonl");
        call("sprt", "--scene", "dé.json", "--bot", bot, "--bot", "b=" + bot + " x", "--games", "2");
        call("key", "new", "kéy");
        call("referee", "-scene", "dé.json", "-p1", "json:" + bot, "-p2", "builtin:racer", "-r", "ré.jsonl", "-l",
            "lé.json");
        call("play", "--json-league", "json:" + bot, "builtin:racer", "--scene", "dé.json", "--out", "plé.jsonl");
        call("league", "init", "Liga é", "--scene", "dé.json");
        call("league", "add", "Liga é", "José=" + bot, "builtin:racer");
        assertTrue(Files.readString(place.resolve("Liga é/league.json")).contains("José"));
        call("league", "run", "Liga é", "--games", "2");
        call(0, Map.of("LC_ALL", "C.UTF-8"), "league", "run", "Liga é", "--games", "4");
        String table = call("league", "table", "Liga é");
        assertTrue(table.contains("José") && !table.contains("José#"), "the same version in every locale:\n" + table);
        call("league", "page", "Liga é", "--out", "Lé.html");
        for (String view : List.of("games", "export", "verify", "list")) {
            call("league", view, "Liga é");
        }
        Files.writeString(Files.createDirectory(place.resolve("Klasse é")).resolve("Zoë.py"),
            Files.readString(place.resolve("Zoë/bot.py")));
        Files.copy(place.resolve("Klasse é/Zoë.py"), place.resolve("Klasse é/Ñandú.py"));
        String names = call("tournament", "Klasse é", "--protocol", "json", "--games", "2");
        assertTrue(names.contains("Zoë") && names.contains("Ñandú"), names);
        assertTrue(call(2, Map.of(), "match", "--bot", "./ñ", "--bot", "./ñ").contains("'./ñ'"));
        try (Stream<Path> all = Files.walk(place)) {
            String wrong = all.map(Path::toString).filter(each -> each.contains("?") || each.contains("\uFFFD"))
                .collect(Collectors.joining("\n"));
            assertEquals("", wrong, CommandLine.quote(List.of(place.toString())));
        }
    }
}
