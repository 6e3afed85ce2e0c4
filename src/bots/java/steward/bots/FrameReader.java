package steward.bots;

import java.util.Arrays;
import tools.jackson.core.JsonParser;
import tools.jackson.core.JsonToken;

/**
 * Reads the frames that the referee sends, one JSON object a line, token by token into {@link Race} and {@link Pods}.
 * Fields that no bot here uses, or that a later version adds, are skipped.
 */
final class FrameReader {

    /** The type of a line. */
    enum Type { SETUP, TURN, END, OTHER }

    final Race race = new Race();
    final Pods pods = new Pods();

    /**
     * Reads one line.
     *
     * @throws tools.jackson.core.JacksonException if it is not JSON or a value is not of the type expected
     */
    Type read(JsonParser in) {
        Type type = Type.OTHER;
        in.nextToken();
        while (in.nextToken() == JsonToken.PROPERTY_NAME) {
            String name = in.currentName();
            in.nextToken();
            switch (name) {
                case "type" -> type = type(in.getString());
                case "player" -> race.player = in.getIntValue();
                case "laps" -> race.laps = in.getIntValue();
                case "checkpoints" -> readCheckpoints(in);
                case "checkpointRadius" -> race.checkpointRadius = in.getDoubleValue();
                case "podRadius" -> race.podRadius = in.getDoubleValue();
                case "podMass" -> race.podMass = in.getDoubleValue();
                case "minimumImpulse" -> race.minimumImpulse = in.getDoubleValue();
                case "drag" -> race.drag = in.getDoubleValue();
                case "maximumThrust" -> race.maximumThrust = in.getIntValue();
                case "boostThrust" -> race.boostThrust = in.getIntValue();
                case "field" -> readField(in);
                case "pods" -> readPods(in);
                default -> in.skipChildren();
            }
        }
        return type;
    }

    private static Type type(String name) {
        return switch (name) {
            case "setup" -> Type.SETUP;
            case "turn" -> Type.TURN;
            case "end" -> Type.END;
            default -> Type.OTHER;
        };
    }

    private void readCheckpoints(JsonParser in) {
        race.checkpoints = 0;
        while (in.nextToken() == JsonToken.START_OBJECT) {
            int k = race.checkpoints++;
            if (k == race.checkpointX.length) {
                race.checkpointX = Arrays.copyOf(race.checkpointX, 2 * k);
                race.checkpointY = Arrays.copyOf(race.checkpointY, 2 * k);
            }
            while (in.nextToken() == JsonToken.PROPERTY_NAME) {
                String name = in.currentName();
                in.nextToken();
                switch (name) {
                    case "x" -> race.checkpointX[k] = in.getDoubleValue();
                    case "y" -> race.checkpointY[k] = in.getDoubleValue();
                    default -> in.skipChildren();
                }
            }
        }
    }

    private void readField(JsonParser in) {
        while (in.nextToken() == JsonToken.PROPERTY_NAME) {
            String name = in.currentName();
            in.nextToken();
            switch (name) {
                case "width" -> race.width = in.getDoubleValue();
                case "height" -> race.height = in.getDoubleValue();
                case "walls" -> race.walls = in.currentToken() == JsonToken.VALUE_TRUE;
                case "bumpers" -> readBumpers(in);
                default -> in.skipChildren();
            }
        }
    }

    private void readBumpers(JsonParser in) {
        race.bumpers = 0;
        while (in.nextToken() == JsonToken.START_OBJECT) {
            int k = race.bumpers++;
            if (k == race.bumperX.length) {
                race.bumperX = Arrays.copyOf(race.bumperX, 2 * k);
                race.bumperY = Arrays.copyOf(race.bumperY, 2 * k);
                race.bumperRadius = Arrays.copyOf(race.bumperRadius, 2 * k);
            }
            while (in.nextToken() == JsonToken.PROPERTY_NAME) {
                String name = in.currentName();
                in.nextToken();
                switch (name) {
                    case "x" -> race.bumperX[k] = in.getDoubleValue();
                    case "y" -> race.bumperY[k] = in.getDoubleValue();
                    case "radius" -> race.bumperRadius[k] = in.getDoubleValue();
                    default -> in.skipChildren();
                }
            }
        }
    }

    private void readPods(JsonParser in) {
        pods.clear();
        while (in.nextToken() == JsonToken.START_OBJECT) {
            readPod(in, pods.add());
        }
    }

    private void readPod(JsonParser in, int pod) {
        double heading = Double.NaN;
        int lap = 0;
        pods.shieldTimer[pod] = 0;
        pods.boostLeft[pod] = false;
        while (in.nextToken() == JsonToken.PROPERTY_NAME) {
            String name = in.currentName();
            JsonToken value = in.nextToken();
            switch (name) {
                case "player" -> pods.player[pod] = in.getIntValue();
                case "x" -> pods.x[pod] = in.getDoubleValue();
                case "y" -> pods.y[pod] = in.getDoubleValue();
                case "vx" -> pods.vx[pod] = in.getDoubleValue();
                case "vy" -> pods.vy[pod] = in.getDoubleValue();
                case "heading" -> heading = value == JsonToken.VALUE_NULL ? Double.NaN : in.getDoubleValue();
                case "nextCheckpoint" -> pods.next[pod] = in.getIntValue();
                case "lap" -> lap = in.getIntValue();
                case "shieldTimer" -> pods.shieldTimer[pod] = in.getIntValue();
                case "boostLeft" -> pods.boostLeft[pod] = value == JsonToken.VALUE_TRUE;
                default -> in.skipChildren();
            }
        }
        boolean unset = Double.isNaN(heading);
        double radians = unset ? 0 : StrictMath.toRadians(heading);
        pods.headingX[pod] = unset ? 0 : StrictMath.cos(radians);
        pods.headingY[pod] = unset ? 0 : StrictMath.sin(radians);
        pods.passed[pod] = lap * race.checkpoints + (pods.next[pod] + race.checkpoints - 1) % race.checkpoints;
    }
}
