package steward.cli.setup;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import steward.bot.command.CommandLine;
import steward.bot.command.ProgramFinder;
import steward.cli.Cli;
import steward.cli.ShellBots;
import steward.league.LeagueFolder;
import steward.league.store.GameStore;
import steward.match.TestScenes;
import steward.match.TestSize;

/** Starters of every language that are built anew, or edited, while a series is played. */
@Tag("process")
@Tag("slow")
@Timeout(300)
class StarterWatchTest {

    @TempDir
    private Path folder;
    private Path place;
    private Path scene;

    /** All; in {@code test} the first. */
    static Stream<StarterLanguage> languages() {
        return Stream.of(StarterLanguage.values()).limit(TestSize.of(1, StarterLanguage.values().length));
    }

    /** A line by which a source becomes another program: a comment moves lines of Java's classes, and of no binary. */
    private static String change(StarterLanguage language) {
        return switch (language) {
            case PYTHON -> "# made anew\n";
            case CPP -> "int madeAnew = 1;\n";
            case JAVA, JS -> "// made anew\n";
        };
    }

    /** Makes the program, and once more from a changed source in another folder. */
    private void make(StarterLanguage language) throws IOException, InterruptedException {
        scene = Files.writeString(folder.resolve("brief.json"), TestScenes.text("mad-pod-racing")
            .replaceFirst("\"maximumTurns\": \\d+", "\"maximumTurns\": 4"));
        place = folder.resolve("bot");
        Path anew = folder.resolve("anew");
        for (Path each : List.of(place, anew)) {
            Cli.run("new", language.word(), each.toString()).done();
        }
        Path source = anew.resolve(language.source());
        Files.writeString(source, change(language) + Files.readString(source));
        for (Path each : List.of(place, anew)) {
            for (String command : language.compile()) {
                List<String> words = CommandLine.split(command);
                assumeTrue(ProgramFinder.find(words.get(0)) != null, "there is no " + words.get(0));
                assertEquals(0, new ProcessBuilder(words).directory(each.toFile()).inheritIO().start().waitFor());
            }
        }
    }

    /** Plays against a bot that puts the new program in place at its own third start: in the third game. */
    private Cli sprt(StarterLanguage language, String... more) throws IOException {
        String builder = """
            cd '%s' || exit 9
            echo >>starts
            if [ "$(wc -l <starts)" -eq 3 ]; then
              for file in anew/*; do cp -p "$file" put && mv put "bot/${file#anew/}"; done
            fi
            while IFS= read -r line; do
              case $line in *'"type":"turn"'*) ;; *) continue ;; esac
              echo '{"pods":[{"x":0,"y":0,"thrust":0},{"x":0,"y":0,"thrust":0}]}'
            done
            """.formatted(folder);
        Files.writeString(folder.resolve("builder.sh"), builder);
        List<String> words = Stream.concat(Stream.of("sprt", "--bot",
            "me=" + language.bot(language.usual()), "--in", place.toString(), "--bot", "builder=sh builder.sh", "--in",
            folder.toString(), "--scene", scene.toString(), "--seed", "1", "--time-factor", "60", "--sandbox", "off"),
            Stream.of(more)).toList();
        return Cli.run(words.toArray(String[]::new));
    }

    @ParameterizedTest
    @MethodSource("languages")
    @Tag("sized")
    void aChangeEndsTheTestUndecidedAndNamesItsFile(StarterLanguage language) throws IOException, InterruptedException {
        assumeTrue(ShellBots.runnable(), "skipped: there is no /bin/sh");
        make(language);
        Cli ended = sprt(language, "--games", "1000");
        assertEquals(1, ended.status(), ended.out() + ended.err());
        String said = ended.out() + ended.err();
        String file = switch (language) {
            case JAVA -> "Bot[^/]*\\.class";           // one of its classes
            case CPP -> "bot";
            case PYTHON, JS -> Pattern.quote(language.source());
        };
        assertTrue(Pattern.compile("the test ends undecided after 2 games: " + Pattern.quote(place + "/") + file
            + " has changed").matcher(said).find(), said);
    }

    @ParameterizedTest
    @MethodSource("languages")
    @Tag("sized")
    void inALeagueANewVersionBegins(StarterLanguage language) throws IOException, InterruptedException {
        assumeTrue(ShellBots.runnable(), "skipped: there is no /bin/sh");
        make(language);
        Cli.run("league", "init", folder.resolve("night").toString(), "--scene", scene.toString(), "--time-factor",
            "60").done();
        Cli played = sprt(language, "--games", "6", "--into", folder.resolve("night").toString()).done();
        assertTrue(played.err().contains("it begins anew, with a new version"), played.err());
        try (GameStore store = GameStore.read(new LeagueFolder(folder.resolve("night")))) {
            assertEquals("me 2, builder 8, me#2 6", store.versions().stream().map(version -> version.display() + " "
                + store.gamesOf(version.id())).collect(Collectors.joining(", ")));
        }
    }
}
