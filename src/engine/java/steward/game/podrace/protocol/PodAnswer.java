package steward.game.podrace.protocol;

import java.util.Arrays;
import java.util.Set;
import java.util.TreeSet;
import steward.Internal;
import steward.game.JsonNumbers;
import steward.game.LineParser;
import steward.game.LineScan;
import steward.game.RawJson;
import steward.game.podrace.PodRace;
import steward.scene.json.JsonProblem;
import steward.text.NearestName;
import steward.text.TextFormat;
import tools.jackson.core.JacksonException;
import tools.jackson.core.JsonParser;
import tools.jackson.core.JsonToken;
import tools.jackson.core.ObjectReadContext;

/**
 * Reads one answer of a pod-race bot,
 * <pre>{"pods":[{"x":1,"y":2.5,"thrust":100},{"x":1,"y":2,"shield":true}],"message":"optional"}</pre>
 * token by token. An error is returned as a sentence, because a wrong answer is frequent and not an exception.
 */
@Internal
public final class PodAnswer {

    private static final Set<String> POD_FIELDS = new TreeSet<>(Set.of("x", "y", "thrust", "shield", "boost"));
    private static final Set<String> FIELDS = new TreeSet<>(Set.of("pods", "message"));
    private static final int NOT_GIVEN = Integer.MIN_VALUE;

    private static final byte[] PODS = RawJson.text("\"pods\"");
    private static final byte[] X = RawJson.text("\"x\"");
    private static final byte[] Y = RawJson.text("\"y\"");
    private static final byte[] THRUST = RawJson.text("\"thrust\"");
    private static final byte[] SHIELD = RawJson.text("\"shield\"");
    private static final byte[] BOOST = RawJson.text("\"boost\"");
    private static final byte[] TRUE = RawJson.text("true");

    private final double[] x;
    private final double[] y;
    private final int[] thrust;
    private int podsRead;
    private final int maximumThrust;
    private final LineScan scan = new LineScan();
    private final LineParser lines = new LineParser();
    private String message;

    /**
     * @param pods          how many pods an answer must command
     * @param maximumThrust the greatest ordinary thrust
     */
    public PodAnswer(int pods, int maximumThrust) {
        this.maximumThrust = maximumThrust;
        x = new double[pods];
        y = new double[pods];
        thrust = new int[pods];
    }

    /** Makes what was read the commands of a player's first pods. */
    void command(PodRace race, int player, int pods) {
        int first = player * x.length;
        for (int pod = 0; pod < pods; pod++) {
            race.command(first + pod, x[pod], y[pod], thrust[pod]);
        }
    }

    double x(int pod) {
        return x[pod];
    }

    double y(int pod) {
        return y[pod];
    }

    /** An ordinary thrust, {@link PodRace#SHIELD} or {@link PodRace#BOOST}. */
    int thrust(int pod) {
        return thrust[pod];
    }

    /** The message of the last valid answer, or {@code null}. */
    public String message() {
        return message;
    }

    /** @return {@code null} if the line is a valid answer, otherwise what is wrong with it */
    public String read(byte[] line, int length) {
        return isPlain(line, length) || isValid(line, length) ? null : readForError(line, length);
    }

    /** The fast path for the usual answer: no message, the fields in the order of the manual. */
    private boolean isPlain(byte[] line, int length) {
        message = null;
        scan.begin(line, length);
        return scan.accept('{') && scan.acceptName(PODS) && arePlainPods() && scan.accept('}') && scan.isAtEnd();
    }

    private boolean arePlainPods() {
        for (int pod = 0; pod < x.length; pod++) {
            if (!scan.accept(pod == 0 ? '[' : ',') || !isPlainPod(pod)) {
                return false;
            }
        }
        return scan.accept(']');
    }

    /**
     * The fast path for the array of pods that begins at a place. The last message is kept.
     *
     * @return the place behind it, or -1 if {@link #readPods} has to be asked
     */
    int readPlainPods(byte[] json, int from, int to) {
        scan.begin(json, from, to);
        return arePlainPods() ? scan.at() : -1;
    }

    private boolean isPlainPod(int pod) {
        if (!scan.accept('{') || !scan.acceptName(X) || !scan.acceptNumber()) {
            return false;
        }
        x[pod] = scan.number();
        if (!scan.accept(',') || !scan.acceptName(Y) || !scan.acceptNumber()) {
            return false;
        }
        y[pod] = scan.number();
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

    /** The path for other valid answers: allocates only the message. */
    private boolean isValid(byte[] line, int length) {
        if (!LineParser.canRead(line, 0, length)) {
            return false;
        }
        message = null;
        try {
            JsonParser in = lines.begin(line, 0, length);
            if (in.nextToken() == JsonToken.START_OBJECT && readFields(in) == null) {
                lines.endValue();
                return lines.restIsBlank();
            }
            lines.reset();
            return false;
        } catch (JacksonException problem) {
            // The error and its position are found by reading the line once more.
            lines.reset();
            return false;
        }
    }

    private String readForError(byte[] line, int length) {
        message = null;
        try (JsonParser in = JsonNumbers.FACTORY.createParser(ObjectReadContext.empty(), line, 0, length)) {
            if (in.nextToken() != JsonToken.START_OBJECT) {
                return "found " + describe(in) + ", expected an object {\"pods\":[...]}";
            }
            String wrong = readFields(in);
            if (wrong != null) {
                return wrong;
            }
            return in.nextToken() == null ? null : "found more after the closing }, expected one object a line";
        } catch (JacksonException problem) {
            // The reader's own limits (digits of a number, length of a name) come without a position.
            String column = problem.getLocation() == null ? "" : ", column " + problem.getLocation().getColumnNr();
            return "not JSON" + column + ": " + JsonProblem.message(problem);
        }
    }

    private String readFields(JsonParser in) {
        boolean hasPods = false;
        while (in.nextToken() == JsonToken.PROPERTY_NAME) {
            String name = in.currentName();
            in.nextToken();
            String wrong;
            switch (name) {
                case "pods" -> {
                    wrong = hasPods ? "pods: found twice, expected once" : readPods(in);
                    hasPods = true;
                }
                case "message" -> wrong = readMessage(in);
                default -> wrong = unknown("", name, FIELDS);
            }
            if (wrong != null) {
                return wrong;
            }
        }
        return hasPods ? null : "pods: found nothing, expected an array of " + count();
    }

    private String readMessage(JsonParser in) {
        if (in.currentToken() != JsonToken.VALUE_STRING) {
            return "message: found " + describe(in) + ", expected a string";
        }
        if (message != null) {
            return "message: found twice, expected once";
        }
        message = in.getString();
        return null;
    }

    /** Reads the array of pods; the parser is on its first token. */
    String readPods(JsonParser in) {
        if (in.currentToken() != JsonToken.START_ARRAY) {
            return "pods: found " + describe(in) + ", expected an array of " + count();
        }
        int pod = 0;
        while (in.nextToken() != JsonToken.END_ARRAY) {
            if (pod == x.length) {
                return "pods: found more than " + x.length + ", expected " + count();
            }
            String wrong = readPod(in, pod++);
            if (wrong != null) {
                return wrong;
            }
        }
        return pod == x.length ? null : "pods: found " + pod + ", expected " + count();
    }

    /** Reads an array of which only the first pods have a command, at least one, and the others are null. */
    String readFirstPods(JsonParser in) {
        podsRead = 0;
        if (in.currentToken() != JsonToken.START_ARRAY) {
            return "pods: found " + describe(in) + ", expected an array of " + count();
        }
        int pod = 0;
        while (in.nextToken() != JsonToken.END_ARRAY) {
            if (pod == x.length) {
                return "pods: found more than " + x.length + ", expected " + count();
            }
            if (in.currentToken() == JsonToken.VALUE_NULL && pod > 0) {
                pod++;
                continue;
            }
            String wrong = podsRead < pod ? path(pod) + ": found " + describe(in) + ", expected null"
                : readPod(in, pod++);
            if (wrong != null) {
                return wrong;
            }
            podsRead = pod;
        }
        return pod == x.length && podsRead < pod ? null
            : "pods: found " + podsRead + " commands of " + pod + ", expected fewer than " + count();
    }

    /** How many pods the last {@link #readFirstPods} has found. */
    int podsRead() {
        return podsRead;
    }

    private String readPod(JsonParser in, int pod) {
        if (in.currentToken() != JsonToken.START_OBJECT) {
            return path(pod) + ": found " + describe(in) + ", expected an object";
        }
        x[pod] = Double.NaN;
        y[pod] = Double.NaN;
        thrust[pod] = NOT_GIVEN;
        while (in.nextToken() == JsonToken.PROPERTY_NAME) {
            String name = in.currentName();
            in.nextToken();
            String wrong = switch (name) {
                case "x" -> readCoordinate(in, "x", x, pod);
                case "y" -> readCoordinate(in, "y", y, pod);
                case "thrust" -> thrust[pod] != NOT_GIVEN ? onlyOne(pod) : readThrust(in, pod);
                case "shield" -> thrust[pod] != NOT_GIVEN ? onlyOne(pod)
                    : readFlag(in, "shield", pod, PodRace.SHIELD);
                case "boost" -> thrust[pod] != NOT_GIVEN ? onlyOne(pod)
                    : readFlag(in, "boost", pod, PodRace.BOOST);
                default -> unknown(path(pod) + ".", name, POD_FIELDS);
            };
            if (wrong != null) {
                return wrong;
            }
        }
        if (Double.isNaN(x[pod]) || Double.isNaN(y[pod])) {
            return path(pod) + (Double.isNaN(x[pod]) ? ".x" : ".y") + ": found nothing, expected a number";
        }
        return thrust[pod] != NOT_GIVEN ? null
            : path(pod) + ": found none of thrust, shield, boost, expected exactly one";
    }

    private static String path(int pod) {
        return "pods[" + pod + "]";
    }

    private static String onlyOne(int pod) {
        return path(pod) + ": found more than one of thrust, shield, boost, expected exactly one";
    }

    private String readCoordinate(JsonParser in, String name, double[] into, int pod) {
        if (!Double.isNaN(into[pod])) {
            return path(pod) + "." + name + ": found twice, expected once";
        }
        if (!in.currentToken().isNumeric() || !Double.isFinite(in.getDoubleValue())) {
            return path(pod) + "." + name + ": found " + describe(in) + ", expected a finite number";
        }
        into[pod] = in.getDoubleValue();
        return null;
    }

    private String readThrust(JsonParser in, int pod) {
        double value = in.currentToken().isNumeric() ? in.getDoubleValue() : Double.NaN;
        if (value != Math.rint(value) || !(value >= 0 && value <= maximumThrust)) {
            return path(pod) + ".thrust: found " + describe(in) + ", expected a whole number 0.." + maximumThrust;
        }
        thrust[pod] = (int) value;                    // 100.0 is a whole number too: some languages print it so
        return null;
    }

    private String readFlag(JsonParser in, String name, int pod, int meaning) {
        if (in.currentToken() != JsonToken.VALUE_TRUE) {
            return path(pod) + "." + name + ": found " + describe(in) + ", expected true (or leave it out)";
        }
        thrust[pod] = meaning;
        return null;
    }

    private static String unknown(String path, String name, Set<String> known) {
        return path + shorten(name) + ": unknown field, expected one of " + String.join(", ", known)
            + NearestName.question(name, known, "");
    }

    private String count() {
        return x.length == 1 ? "1 pod" : x.length + " pods";
    }

    private static String describe(JsonParser in) {
        JsonToken token = in.currentToken();
        if (token == null) {
            return "nothing";
        }
        return switch (token) {
            case START_OBJECT -> "an object";
            case START_ARRAY -> "an array";
            case VALUE_STRING -> "\"" + shorten(in.getString()) + "\"";
            default -> shorten(in.getString());
        };
    }

    private static String shorten(String text) {
        return TextFormat.beginning(text, 40);
    }

    @Override
    public String toString() {
        return "x " + Arrays.toString(x) + ", y " + Arrays.toString(y) + ", thrust " + Arrays.toString(thrust);
    }
}
