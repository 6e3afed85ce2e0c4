package steward.minigame.airhockey;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.ResourceLock;
import steward.bot.Bot;
import steward.game.Game;
import steward.game.GameSetup;
import steward.game.GameTypes;
import steward.game.Pilot;
import steward.minigame.MiniScenes;
import steward.numerics.SplitMix64;
import steward.replay.Recorded;
import steward.replay.page.PageTestBrowser;
import steward.replay.page.PageTestPages;
import steward.replay.verify.Verification;
import steward.scene.json.SceneException;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** The game that the manual's page on adding one leads to, through the whole program: played, verified, drawn. */
class AirHockeyTest {

    private static final GameTypes TYPES = new GameTypes(List.of(new AirHockeyType()));

    @TempDir
    static Path folder;

    private static GameSetup open(String... fromTo) {
        return MiniScenes.open(TYPES, "airhockey.json", fromTo);
    }

    /** Pushes its paddle at the puck; in one turn it says something else. */
    private static Bot chaser(int player, int strangeTurn, String strange) {
        return new Bot() {

            private int turn;

            @Override
            public void setup(String line) {
                turn = 0;
            }

            @Override
            public String turn(String line) {
                JsonNode bodies = JsonMapper.shared().readTree(line).get("bodies");
                double dx = bodies.get(2).get("x").asDouble() - bodies.get(player).get("x").asDouble();
                double dy = bodies.get(2).get("y").asDouble() - bodies.get(player).get("y").asDouble();
                double share = 39 / Math.max(1, Math.sqrt(dx * dx + dy * dy));
                return ++turn == strangeTurn ? strange
                    : "{\"x\":" + dx * share + ",\"y\":" + dy * share + ",\"message\":\"go\"}";
            }
        };
    }

    private static Recorded match(long seed) {
        return Recorded.of(open(), seed, List.of(chaser(0, 0, ""), chaser(1, 0, "")));
    }

    @Test
    void matchesWithGoalsVerifyAndTheSameSeedGivesTheSameBytes() {
        int goals = 0;
        for (long seed = 1; seed <= 10; seed++) {
            Recorded match = match(seed);
            Verification found = Recorded.verify(match.bytes(), TYPES);
            assertTrue(found.verified(), "seed " + seed + ": " + found.difference());
            assertFalse(match.result().anyFault(), "seed " + seed + ": " + match.result());
            assertEquals(match.withoutTimes(), match(seed).withoutTimes(), "seed " + seed);
            goals += match.text().split("goal of player", -1).length - 1;
        }
        assertTrue(goals >= 5, goals + " goals");
    }

    @Test
    void aChangedPushIsFound() {
        Recorded match = match(3);
        String line = match.lines().get(5);
        String changed = line.replaceFirst("\"commands\":\\[\\{\"x\":[-0-9.]+", "\"commands\":[{\"x\":1");
        assertFalse(line.equals(changed), line);
        Verification found = Recorded.verify(
            match.text().replace(line, changed).getBytes(StandardCharsets.UTF_8), TYPES);
        assertEquals(5, found.difference().turn());
    }

    @Test
    void aCopyGoesOnAlike() {
        GameSetup setup = open();
        Game game = setup.create(4);
        SplitMix64 random = new SplitMix64(4);
        for (int turn = 0; turn < 60 && !game.isOver(); turn++) {
            Game copy = game.copy();
            assertEquals(game.hash(), copy.hash());
            for (int player = 0; player < 2; player++) {
                byte[] line = setup.pilot(Pilot.Aim.WIN).answer(game, player, random).getBytes(StandardCharsets.UTF_8);
                assertEquals(null, setup.codec(game).readAnswer(player, line, line.length));
                setup.codec(copy).readAnswer(player, line, line.length);
            }
            game.play();
            assertTrue(game.hash() != copy.hash(), "the copy stays as it was");
            copy.play();
            assertEquals(game.hash(), copy.hash(), "turn " + turn);
        }
    }

    /** The puck starts 500 u from the wall at 800 u a turn, straight at the goal: after 460 / 800 of the turn. */
    @Test
    void aPuckInTheGoalScoresAndAllGoBackToTheirPlaces() {
        Game game = open("\"drag\": 0.02", "\"drag\": 0").create(1);
        game.bodies().setPosition(0, 500, 100);
        game.bodies().setPosition(2, 500, 600);
        game.bodies().setVelocity(2, -800, 0);
        game.play();
        assertArrayEquals(new double[] {0, 1}, game.scores());
        assertEquals(460.0 / 800, game.events().get(0).time(), 1e-12);
        assertArrayEquals(new double[] {500, 1500, 1000, 500, 500, 500}, new double[] {game.bodies().x[0],
            game.bodies().x[1], game.bodies().x[2], game.bodies().y[0], game.bodies().y[1], game.bodies().y[2]});
    }

    @Test
    void faultsSayWhatWasFoundAndTheOtherWins() {
        for (String[] fault : new String[][] {{"{\"x\":1}", "x and y: found not both, expected two numbers"},
            {"{\"x\":40,\"y\":1}", "x and y: found a length of 40.0"}, {"{\"x\":true,\"y\":1}", "x: found true"}}) {
            Recorded match = Recorded.of(open(), 2, List.of(chaser(0, 0, ""), chaser(1, 5, fault[0])));
            assertTrue(match.result().players().get(1).fault().startsWith(fault[1]), match.result().toString());
            assertEquals(0, match.result().winner());
            assertTrue(Recorded.verify(match.bytes(), TYPES).verified());
        }
    }

    @Test
    void aMisspeltFieldIsLocated() {
        String problem = assertThrows(SceneException.class, () -> open("\"goal\"", "\"gaol\"")).getMessage();
        assertTrue(problem.startsWith("airhockey.json:17:") && problem.contains("\"gaol\""), problem);
    }

    @Test
    @Tag("browser")
    @ResourceLock(PageTestBrowser.LOCK)
    void thePageDrawsEveryTurn() {
        Path page = new PageTestPages(folder).page(match(7).bytes(), "Air hockey");
        try (PageTestBrowser browser = PageTestBrowser.start()) {
            browser.open(page, "");
            browser.run("steward.pause()");
            assertEquals("Air hockey", browser.text("h1"));
            browser.draw(0, 100, 2.5);
            assertEquals(List.of(), browser.complaints());
        }
    }
}
