package steward.game.podrace.simulator;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.game.GameSetup;
import steward.game.podrace.PodRace;
import steward.game.podrace.Races;
import steward.game.podrace.TurnKernel;
import steward.game.podrace.protocol.PodRaceType.PodRaceSetup;
import steward.match.TestScenes;
import steward.numerics.SplitMix64;
import steward.physics.TurnLog;
import steward.physics.event.Scenes;

/**
 * Races as matches play them against the general way with the event loop of every scene, bit for bit: every hash, and
 * the impacts whether they are asked for or not. {@code -Psteward.turns} and {@code -Psteward.seed} as elsewhere.
 */
@Execution(ExecutionMode.CONCURRENT)
class MatchTurnTest {

    private static final long TURNS = Long.getLong("steward.turns", 60_000) / 6;
    private static final long SEED = Long.getLong("steward.seed", 5);
    private static final String OFFICIAL = "mad-pod-racing";

    private static TurnKernel kernel(GameSetup scene) {
        PodRaceSetup setup = (PodRaceSetup) scene;
        return MatchTurn.of(setup.settings(), setup.scene(), setup.plan(), setup.create(1).checkpoints(),
            setup.plan().advance(null), new TurnLog());
    }

    @Test
    void scenesOfOtherNumbersHaveTheGeneralWay() {
        assertNotNull(kernel(TestScenes.open(OFFICIAL)));
        assertNull(kernel(TestScenes.open("walled-race")));
        List.of("\"drag\": 0.15/\"drag\": 0.14", "\"velocity\": \"truncate\", /", "\"radius\": 400/\"radius\": 300",
            "\"mass\": 1/\"mass\": 2", "\"mass\": 1/\"mass\": 1, \"restitution\": 0.5",
            "\"mass\": 1/\"mass\": 1, \"maximumThrust\": 100", "Impulse\": 120/Impulse\": 100",
            "Radius\": 600/Radius\": 500", "\"official\" }/\"double\" }", "\"perPlayer\": 2/\"perPlayer\": 8")
            .forEach(change -> assertNull(kernel(TestScenes.changed(OFFICIAL, change.split("/")[0],
                change.endsWith("/") ? "" : change.split("/")[1])), change));
    }

    @Test
    void theOfficialRace() {
        check(TestScenes.open(OFFICIAL));
    }

    @Test
    void theRulesOfTheContest() {
        check(TestScenes.contest(OFFICIAL));
    }

    @Test
    @Tag("slow")
    void otherNumbersOfPods() {
        check(TestScenes.changed(OFFICIAL, "\"perPlayer\": 2", "\"perPlayer\": 1"));
        check(TestScenes.changed(OFFICIAL, "\"players\": 2", "\"players\": 1"));
        check(TestScenes.changed(OFFICIAL, "\"players\": 2", "\"players\": 4"));
    }

    private static void check(GameSetup scene) {
        assertNotNull(kernel(scene));
        PodRaceSetup setup = (PodRaceSetup) scene;
        SplitMix64 random = new SplitMix64(SEED);
        long turns = 0;
        long impacts = 0;
        for (long game = 0; turns < TURNS; game++) {
            PodRace fast = setup.create(game);
            PodRace plain = Races.plain(setup, fast.checkpoints());
            boolean brawl = random.nextInt(2) == 0;
            while (!plain.isOver()) {
                for (int pod = 0; pod < setup.settings().pods(); pod++) {
                    command(plain, fast, pod, brawl, random);
                }
                if (random.nextInt(200) == 0) {
                    int player = random.nextInt(plain.players());
                    plain.eliminate(player, "chance");
                    fast.eliminate(player, "chance");
                }
                plain.play();
                fast.play();
                turns++;
                String where = "seed " + SEED + ", game " + game + ", turn " + plain.turn();
                int question = random.nextInt(4);
                if (question == 0) {
                    Scenes.assertSameLog(plain.log(), fast.log(), () -> where);
                    impacts += plain.log().impacts();
                } else if (question == 1) {
                    fast = fast.copy();
                }
                if (question < 3 || plain.isOver()) {                 // headings may be asked for turns later
                    assertEquals(plain.hash(), fast.hash(), where);
                }
            }
            assertEquals(plain.ending(), fast.ending());
        }
        assertTrue(impacts > 0 || setup.settings().pods() == 1, "no impacts");
    }

    private static void command(PodRace plain, PodRace fast, int pod, boolean brawl, SplitMix64 random) {
        int kind = random.nextInt(40);
        int thrust = kind == 0 ? PodRace.SHIELD : kind == 1 ? PodRace.BOOST : kind == 2 ? PodRace.NO_COMMAND
            : kind < 20 ? 200 : random.nextInt(0, 200);
        int enemy = random.nextInt(plain.settings().pods());
        double[] next = plain.checkpoints()[plain.nextCheckpoint(pod)];
        double aimX = brawl ? plain.bodies().x[enemy] : next[0] - 3 * plain.bodies().vx[pod];
        double aimY = brawl ? plain.bodies().y[enemy] : next[1] - 3 * plain.bodies().vy[pod];
        boolean still = random.nextInt(100) == 0;
        double x = still ? plain.bodies().x[pod] : aimX + random.nextInt(-500, 500);
        double y = still ? plain.bodies().y[pod] : aimY + random.nextInt(-500, 500);
        plain.command(pod, x, y, thrust);
        fast.command(pod, x, y, thrust);
    }
}
