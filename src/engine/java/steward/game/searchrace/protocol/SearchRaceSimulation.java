package steward.game.searchrace.protocol;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import steward.game.SimulationLines;
import steward.game.searchrace.OfficialSearchRace;
import steward.game.searchrace.SearchRace;
import tools.jackson.core.io.NumberOutput;

/**
 * Line protocol with which simulators of the search race are checked. A test is
 * <pre>
 * x y vx vy angleDegrees passed
 * X Y THRUST | EXPERT ANGLE THRUST
 * </pre>
 * and its answer is the new state in the same form, followed by the time of the last checkpoint passed in the turn (2.0
 * if none was).
 */
final class SearchRaceSimulation extends SimulationLines {

    private static final String[] STATE = {"x", "y", "vx", "vy", "angleDegrees", "passed"};

    private final SearchRaceType.SearchRaceSetup setup;

    SearchRaceSimulation(SearchRaceType.SearchRaceSetup setup, BufferedReader in, PrintStream out) {
        super(in, out);
        this.setup = setup;
    }

    @Override
    protected String answer(double[][] course) throws IOException {
        SearchRace race = setup.create(course);
        String[] words = words("state: ", String.join(" ", STATE));
        double[] state = new double[STATE.length - 1];
        for (int k = 0; k < state.length; k++) {
            state[k] = number(words[k], STATE[k]);
        }
        race.set(state[0], state[1], state[2], state[3], OfficialSearchRace.radians(state[4]),
            whole(words[5], "passed", 0, race.toFinish() - 1), 0, SearchRace.NOT_PASSED);
        byte[] command = required("command: X Y THRUST or EXPERT ANGLE THRUST").getBytes(StandardCharsets.UTF_8);
        String wrong = new SearchRaceText(race).readAnswer(0, command, command.length);
        if (wrong != null) {
            throw wrong(wrong);
        }
        race.play();
        return plain(race.bodies().x[0]) + " " + plain(race.bodies().y[0]) + " " + plain(race.bodies().vx[0]) + " "
            + plain(race.bodies().vy[0]) + " " + OfficialSearchRace.degrees(race.heading()) + " " + race.passed() + " "
            + NumberOutput.toString(race.passTime(), true) + System.lineSeparator();
    }
}
