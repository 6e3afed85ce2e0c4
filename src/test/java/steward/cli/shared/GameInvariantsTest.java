package steward.cli.shared;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import steward.game.Game;
import steward.game.GameSetup;
import steward.game.Pilot;
import steward.match.TestSize;
import steward.numerics.SplitMix64;
import steward.physics.Bodies;
import steward.physics.Impact;
import steward.scene.Accuracy;
import steward.scene.SceneFiles;

/**
 * Invariants of every turn of every shipped scene on every kind of rung: states are finite, impacts are in order, what
 * one body gains the other loses, energies follow from the velocities, and a copy of a game goes on as the game does.
 */
@Execution(ExecutionMode.CONCURRENT)
class GameInvariantsTest {

    private static final int MOST_TURNS = 120;
    /** Of the momentum exchanged: a few roundings of each velocity, and the official expressions' roundings of 1/m. */
    private static final double MOMENTUM_GAP = 1e-12;
    private static final double ENERGY_GAP = 1e-9;

    private static Stream<Arguments> scenesAndRungs() {
        return SceneFiles.shipped().stream().flatMap(scene -> rungs(scene).map(rung -> Arguments.of(scene, rung)));
    }

    /** In {@code test} two of them. */
    private static Stream<String> rungs(String scene) {
        return TestSize.isWhole() ? Stream.of("official", "double", "exact", "step/16")
            : scene.hashCode() % 2 == 0 ? Stream.of("official", "double") : Stream.of("exact", "step/16");
    }

    @ParameterizedTest
    @MethodSource("scenesAndRungs")
    @Tag("slow")
    @Tag("sized")
    void everyTurnKeepsThem(String scene, String rung) {
        int mostTurnsAlone = TestSize.of(10, 40);         // heaps of hundreds take long
        GameSetup setup = Games.open(scene, Accuracy.parse(rung));
        int impacts = 0;
        int turns = 0;
        boolean alone = setup.scene().players() == 0;
        int games = alone ? 1 : TestSize.of(1, 2);             // nobody plays otherwise there
        int mostTurns = alone ? mostTurnsAlone : MOST_TURNS;
        for (int seed = 1; seed <= games; seed++) {
            Game game = setup.create(seed);
            Game again = setup.create(seed);
            Pilot pilot = setup.pilot(seed % 2 == 0 ? Pilot.Aim.WIN : Pilot.Aim.MINGLE);
            SplitMix64 random = new SplitMix64(seed);
            while (!game.isOver() && game.turn() < mostTurns) {
                String place = scene + ", " + rung + ", seed " + seed + ", turn " + (game.turn() + 1);
                Game copied = again;
                long before = copied.hash();
                again = copied.copy();
                for (int player = 0; player < game.players(); player++) {
                    if (game.isIn(player)) {
                        byte[] answer = pilot.answer(game, player, random).getBytes(StandardCharsets.UTF_8);
                        setup.codec(game).readAnswer(player, answer, answer.length);
                        setup.codec(again).readAnswer(player, answer, answer.length);
                    }
                }
                game.play();
                again.play();
                assertEquals(game.hash(), again.hash(), place + ": the copy");
                assertEquals(before, copied.hash(), place + ": of whom the copy is");
                check(game, place);
                impacts += game.log().impacts();
                turns++;
            }
        }
        assertTrue(turns >= games * (alone ? mostTurnsAlone : 20), turns + " turns");
        assertTrue(impacts > 0 || setup.scene().players() == 1, "bodies of several players meet");
    }

    private static void check(Game game, String place) {
        Bodies bodies = game.bodies();
        for (int k = 0; k < bodies.size(); k++) {
            assertTrue(Double.isFinite(bodies.x[k] + bodies.y[k] + bodies.vx[k] + bodies.vy[k]),
                place + ": body " + bodies.id(k));
            assertTrue(k == 0 || bodies.id(k) != bodies.id(k - 1), place + ": ids");
        }
        double time = 0;
        for (int k = 0; k < game.log().kept(); k++) {
            Impact impact = game.log().impact(k);
            assertTrue(impact.time() >= time && impact.time() <= 1, place + ": impact at " + impact.time()
                + " after " + time);
            time = impact.time();
            check(impact, place + ", impact " + k);
        }
    }

    private static void check(Impact impact, String place) {
        double ax = impact.momentumAx();
        double ay = impact.momentumAy();
        if (!impact.isWall()) {
            double size = momentum(impact);
            assertEquals(0, (ax + impact.momentumBx()) / size, MOMENTUM_GAP, place);
            assertEquals(0, (ay + impact.momentumBy()) / size, MOMENTUM_GAP, place);
        }
        double before = energy(impact.massA(), impact.vaxBefore(), impact.vayBefore())
            + energy(impact.massB(), impact.vbxBefore(), impact.vbyBefore());
        double after = energy(impact.massA(), impact.vaxAfter(), impact.vayAfter())
            + energy(impact.massB(), impact.vbxAfter(), impact.vbyAfter());
        assertEquals(after - before, impact.energy(), ENERGY_GAP * (before + after), place);
    }

    /** Momentum of both bodies, of which their gains are differences. */
    private static double momentum(Impact impact) {
        double a = Double.isInfinite(impact.massA()) ? 0 : impact.massA()
            * Math.max(Math.hypot(impact.vaxBefore(), impact.vayBefore()),
                Math.hypot(impact.vaxAfter(), impact.vayAfter()));
        double b = Double.isInfinite(impact.massB()) ? 0 : impact.massB()
            * Math.max(Math.hypot(impact.vbxBefore(), impact.vbyBefore()),
                Math.hypot(impact.vbxAfter(), impact.vbyAfter()));
        return Math.max(a + b, Double.MIN_NORMAL);
    }

    private static double energy(double mass, double vx, double vy) {
        return Double.isInfinite(mass) ? 0 : mass * (vx * vx + vy * vy) / 2;
    }
}
