package steward.game.podrace;

import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import steward.numerics.SplitMix64;
import steward.physics.Bodies;

/** The race between walls and bumpers, driven as wildly as commands allow: nobody gets out or into anything. */
class WalledRaceTest {

    private static final int TURNS = 4000;
    private static final double WIDTH = 16_000;
    private static final double HEIGHT = 9000;
    /** At the end of a turn a place moves by at most half a unit along each axis. */
    private static final double ROUNDING = Math.sqrt(0.5);

    private int impacts;

    /** @param wallward how many commands of a hundred aim beyond the walls */
    @ParameterizedTest
    @ValueSource(ints = {10, 60, 95})
    void podsStayInTheBoxAndOutOfTheBumpers(int wallward) {
        SplitMix64 random = new SplitMix64(wallward);
        PodRace race = Races.setup("walled-race").create(random.nextLong());
        for (int turn = 0; turn < TURNS; turn++) {
            if (race.isOver()) {
                race = Races.setup("walled-race").create(random.nextLong());
            }
            for (int pod = 0; pod < 4; pod++) {
                command(race, pod, random, random.nextInt(100) < wallward);
            }
            race.play();
            check(race);
        }
        assertTrue(impacts > TURNS / 4, "impacts with walls and bumpers: " + impacts);
    }

    private static void command(PodRace race, int pod, SplitMix64 random, boolean wallward) {
        double x = wallward ? random.nextInt(2) * 2 * WIDTH - WIDTH / 2 : random.nextInt((int) WIDTH);
        double y = wallward ? random.nextInt(2) * 2 * HEIGHT - HEIGHT / 2 : random.nextInt((int) HEIGHT);
        if (random.nextInt(4) == 0) {                     // at a bumper
            int bumper = 4 + random.nextInt(3);
            x = race.bodies().x[bumper];
            y = race.bodies().y[bumper];
        }
        int thrust = switch (random.nextInt(12)) {
            case 0 -> PodRace.SHIELD;
            case 1 -> PodRace.BOOST;
            default -> 200;
        };
        race.command(pod, x, y, thrust);
    }

    private void check(PodRace race) {
        Bodies bodies = race.bodies();
        for (int pod = 0; pod < 4; pod++) {
            double x = bodies.x[pod];
            double y = bodies.y[pod];
            double r = bodies.radius[pod];
            assertTrue(x >= r && x <= WIDTH - r && y >= r && y <= HEIGHT - r,
                () -> "out of the box: " + x + ", " + y);
            for (int bumper = 4; bumper < 7; bumper++) {
                double dx = x - bodies.x[bumper];
                double dy = y - bodies.y[bumper];
                double depth = r + bodies.radius[bumper] - Math.sqrt(dx * dx + dy * dy);
                assertTrue(depth <= ROUNDING, () -> "in a bumper by " + depth);
            }
        }
        for (int bumper = 4; bumper < 7; bumper++) {
            assertTrue(bodies.vx[bumper] == 0 && bodies.vy[bumper] == 0, "a bumper moves");
        }
        for (int k = 0; k < race.log().impacts(); k++) {
            impacts += race.log().impact(k).isWall() || race.log().impact(k).b() >= 4 ? 1 : 0;
        }
        assertTrue(!race.log().limited(), "the limit on impacts was reached");
    }
}
