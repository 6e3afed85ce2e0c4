package steward.architecture;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Map;
import java.util.Set;
import java.util.function.BiPredicate;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;

/** Rules that show in the text of files alone; Checkstyle holds those on Java without exceptions. */
class SourceTextTest {

    private static final Map<String, String> FILES = SourceText.ofKind("", "src/engine", "src/main", "src/lab");

    private static boolean has(String text, String pattern) {
        return Pattern.compile(pattern).matcher(text).find();
    }

    private static Set<String> breaking(String files, BiPredicate<String, String> rule) {
        return FILES.entrySet().stream().filter(file -> file.getKey().matches(files))
            .filter(file -> rule.test(file.getKey(), file.getValue()))
            .map(file -> file.getKey().replaceAll(".*/java/steward/|\\.java", "")).collect(Collectors.toSet());
    }

    /**
     * Libraries do not speak of options, but name the parameter, see {@link steward.files.Remedied}: who calls them
     * from Java has none. Excepted are, in this order: options of other programs that are started; a sandbox that
     * league.json has as the words of a call; advice to people who play games, beside what happened, in no exception;
     * the whole call of the workshop that makes a file; calls on the other side of a connection.
     */
    @Test
    void onlyTheseLibrariesSpeakOfOptions() {
        assertEquals(Set.of("bot/isolation/StrictSandbox", "bot/isolation/ShellLauncher", "bot/command/Program",
            "guest/GuestProgram", "live/PagePicture", "league/LeagueText", "league/LeagueReader",
            "league/LeagueSettings", "contest/FailureHints", "contest/FailureStreaks", "league/play/Roster",
            "bot/command/ProgramFinder", "scene/AccuracyFigures", "machines/worker/Worker",
            "machines/serve/WorkerState", "machines/check/GameJar"),
            breaking("src/(engine|main)/java/steward/(?!cli/).*",
                (file, text) -> has(text, "\"[^\"\n]*(?<!-)--[a-z]")));
    }

    /**
     * Files that name a game other than the first, but for its own room and resources, are lists of all games.
     * {@code searchrace} is also {@code search-race} and SearchRace. Bodies are everywhere; the game of this name is
     * known by its package, its types and its files.
     */
    @Test
    void onlyListsNameParticularGames() {
        Map<String, String> games = House.ROOMS.stream().filter(room -> room.matches("game\\.(?!podrace$)\\w+"))
            .collect(Collectors.toMap(room -> room.replace("game.", ""), room -> room.equals("game.bodies")
                ? "steward[./]game[./]bodies|Bodies(Game|Type)|/bodies\\.js"
                : "(?i)" + String.join("-*", room.replace("game.", "").split(""))));
        assertEquals(Set.of("src/engine/resources/META-INF/services/steward.game.GameType", "scene/SceneFiles",
            "src/main/resources/steward/view/page.js"), breaking("src/.*", (file, text) -> games.entrySet().stream()
            .anyMatch(game -> has(text, game.getValue()) && !file.contains("/java/steward/game/" + game.getKey() + "/")
                && !(file.matches("src/\\w+/(resources|schemas)/.*") && has(file, game.getValue())))));
    }
}
