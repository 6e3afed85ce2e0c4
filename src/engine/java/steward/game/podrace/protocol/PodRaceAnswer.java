package steward.game.podrace.protocol;

import java.util.Arrays;
import steward.game.podrace.PodRace;
import steward.json.CommandsAnswer;
import steward.json.LineScan;
import steward.json.RawJson;
import tools.jackson.core.JsonParser;

/**
 * Reader of one answer of a pod-race bot, and of its commands in a replay:
 * <pre>{"pods":[{"x":1,"y":2.5,"thrust":100},{"x":1,"y":2,"shield":true}],"message":"optional"}</pre>
 */
public final class PodRaceAnswer extends CommandsAnswer<Void> {

    private static final int NOT_GIVEN = Integer.MIN_VALUE;

    private static final byte[] PODS = RawJson.text("\"pods\"");
    private static final byte[] X = RawJson.text("\"x\"");
    private static final byte[] Y = RawJson.text("\"y\"");
    private static final byte[] THRUST = RawJson.text("\"thrust\"");
    private static final byte[] SHIELD = RawJson.text("\"shield\"");
    private static final byte[] BOOST = RawJson.text("\"boost\"");
    private static final byte[] TRUE = RawJson.text("true");

    private final double[] targetX;
    private final double[] targetY;
    private final int[] thrust;
    private final int maximumThrust;
    private final LineScan scan = new LineScan();
    private int given;

    /**
     * @param pods          how many pods an answer must command
     * @param maximumThrust the greatest ordinary thrust
     */
    public PodRaceAnswer(int pods, int maximumThrust) {
        super("pods", Double.MAX_VALUE, "x", "y", "thrust", "shield", "boost");
        this.maximumThrust = maximumThrust;
        targetX = new double[pods];
        targetY = new double[pods];
        thrust = new int[pods];
    }

    /** Makes what was read the commands of a player's first pods. */
    void command(PodRace race, int player, int pods) {
        int first = player * thrust.length;
        for (int pod = 0; pod < pods; pod++) {
            race.command(first + pod, targetX[pod], targetY[pod], thrust[pod]);
        }
    }

    /** The usual answer: no message, the fields in the order of the manual. */
    @Override
    protected boolean isPlain(byte[] line, int length) {
        scan.begin(line, length);
        return scan.accept('{') && scan.acceptName(PODS) && arePlainPods() && scan.accept('}') && scan.isAtEnd();
    }

    private boolean arePlainPods() {
        for (int pod = 0; pod < thrust.length; pod++) {
            if (!scan.accept(pod == 0 ? '[' : ',') || !isPlainPod(pod)) {
                return false;
            }
        }
        return scan.accept(']');
    }

    /**
     * The fast path for the array of pods that begins at a place. The last message is kept.
     *
     * @return the place behind it, or -1 if {@link #readArray} has to be asked
     */
    int readPlainPods(byte[] json, int from, int to) {
        scan.begin(json, from, to);
        return arePlainPods() ? scan.at() : -1;
    }

    private boolean isPlainPod(int pod) {
        if (!scan.accept('{') || !scan.acceptName(X) || !scan.acceptNumber()) {
            return false;
        }
        targetX[pod] = scan.number();
        if (!scan.accept(',') || !scan.acceptName(Y) || !scan.acceptNumber()) {
            return false;
        }
        targetY[pod] = scan.number();
        return scan.accept(',') && isPlainThrust(pod) && scan.accept('}');
    }

    private boolean isPlainThrust(int pod) {
        if (scan.acceptName(THRUST)) {
            double value = scan.acceptNumber() ? scan.number() : Double.NaN;
            thrust[pod] = (int) value;
            return thrust[pod] == value && value >= 0 && value <= maximumThrust;
        }
        if (scan.acceptName(SHIELD)) {
            thrust[pod] = PodRace.SHIELD;
        } else if (scan.acceptName(BOOST)) {
            thrust[pod] = PodRace.BOOST;
        } else {
            return false;
        }
        return scan.accept(TRUE);
    }

    @Override
    protected int count() {
        return thrust.length;
    }

    @Override
    protected String counted() {
        return thrust.length == 1 ? "1 pod" : thrust.length + " pods";
    }

    @Override
    protected void beginCommand() {
        given = NOT_GIVEN;
    }

    @Override
    protected String commandField(String field, JsonParser in) {
        if (given != NOT_GIVEN) {
            return field + ": found more than one of thrust, shield, boost, expected exactly one";
        }
        if (!field.equals("thrust")) {
            given = field.equals("shield") ? PodRace.SHIELD : PodRace.BOOST;
            return flag(field, in);
        }
        double value = number(in);
        given = (int) value;
        return isWhole(value, 0, maximumThrust) ? null
            : "thrust: found " + found(in) + ", expected a whole number 0.." + maximumThrust;
    }

    @Override
    protected String endCommand(int pod) {
        targetX[pod] = x;
        targetY[pod] = y;
        thrust[pod] = given;
        String missing = missingTarget();
        return missing != null || given != NOT_GIVEN ? missing
            : ": found none of thrust, shield, boost, expected exactly one";
    }

    @Override
    public String toString() {
        return "x " + Arrays.toString(targetX) + ", y " + Arrays.toString(targetY)
            + ", thrust " + Arrays.toString(thrust);
    }
}
