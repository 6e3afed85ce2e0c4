package steward.game.podrace.protocol;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.PrintStream;
import java.util.Locale;
import steward.game.SimulationLines;
import steward.game.podrace.PodRace;
import steward.game.podrace.PodRaceSettings;
import steward.game.podrace.PodState;

/**
 * Line protocol with which the community checks pod-race simulators. A test is
 * <pre>
 * x y vx vy angleDegrees nextCheckpointId shield boosted   4 times
 * targetX targetY thrust|SHIELD|BOOST                      4 times
 * </pre>
 * and its answer is the four new states in the same form. {@code shield} is 3 after the turn a shield was raised and
 * counts down; {@code boosted} is 1 once the boost is used up. Every state is complete: headings are set.
 */
public final class PodRaceSimulation extends SimulationLines {

    private static final int PODS = 4;

    private final PodRaceType.PodRaceSetup setup;

    /**
     * @param setup a race of four pods
     * @throws IllegalArgumentException if the race has another number of pods
     */
    public PodRaceSimulation(PodRaceType.PodRaceSetup setup, BufferedReader in, PrintStream out) {
        super(in, out);
        if (setup.settings().pods() != PODS) {
            throw new IllegalArgumentException("the scene has " + setup.settings().pods() + " pods, expected " + PODS);
        }
        this.setup = setup;
    }

    @Override
    protected void check(double[][] checkpoints) {
        if (checkpoints[0][0] == checkpoints[1][0] && checkpoints[0][1] == checkpoints[1][1]) {
            throw wrong("found checkpoints 0 and 1 in the same place, expected two places");
        }
    }

    @Override
    protected String answer(double[][] checkpoints) throws IOException {
        PodRace race = setup.create(checkpoints);
        for (int pod = 0; pod < PODS; pod++) {
            race.setPod(pod, readState(pod, checkpoints.length));
        }
        for (int pod = 0; pod < PODS; pod++) {
            String[] words = words("command of pod " + pod + ": ", "targetX targetY thrust|SHIELD|BOOST");
            race.command(pod, number(words[0], "targetX"), number(words[1], "targetY"), thrust(words[2]));
        }
        race.play();
        StringBuilder lines = new StringBuilder();
        for (int pod = 0; pod < PODS; pod++) {
            PodState state = race.pod(pod);
            lines.append(plain(state.x())).append(' ').append(plain(state.y())).append(' ')
                .append(plain(state.vx())).append(' ').append(plain(state.vy())).append(' ')
                .append(plain(PodJsonCache.degrees(state.heading()))).append(' ').append(race.nextCheckpoint(pod))
                .append(' ').append(Math.max(0, state.shieldTimer() - 1)).append(' ')
                .append(state.boostLeft() ? 0 : 1).append('\n');
        }
        return lines.toString();
    }

    private PodState readState(int pod, int checkpoints) throws IOException {
        String[] words = words("state of pod " + pod + ": ",
            "x y vx vy angleDegrees nextCheckpointId shield boosted");
        int next = whole(words[5], "nextCheckpointId", 0, checkpoints - 1);
        int shield = whole(words[6], "shield", 0, PodRaceSettings.SHIELD_TURNS - 1);
        int boosted = whole(words[7], "boosted", 0, 1);
        return new PodState(number(words[0], "x"), number(words[1], "y"), number(words[2], "vx"),
            number(words[3], "vy"), Math.toRadians(number(words[4], "angleDegrees")), shield == 0 ? 0 : shield + 1,
            boosted == 0, (next + checkpoints - 1) % checkpoints);
    }

    private int thrust(String word) {
        return switch (word.toUpperCase(Locale.ROOT)) {
            case "SHIELD" -> PodRace.SHIELD;
            case "BOOST" -> PodRace.BOOST;
            default -> whole(word, "thrust (or SHIELD or BOOST)", 0, setup.settings().maximumThrust());
        };
    }
}
