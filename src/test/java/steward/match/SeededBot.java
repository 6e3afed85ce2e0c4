package steward.match;

import steward.bot.Bot;
import steward.numerics.SplitMix64;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/**
 * A pod-race bot whose commands are valid and drawn by lot: it mostly heads for its next checkpoint, often rams the
 * nearest opponent, and now and then shields, boosts, coasts, aims at itself or at a decimal place. Same seed and
 * frames, same answers.
 */
public final class SeededBot implements Bot {

    private final SplitMix64 random;
    private final double ramming;
    private JsonNode setup;

    /** @param ramming how often it heads for an opponent, 0..1 */
    public SeededBot(long seed, double ramming) {
        random = new SplitMix64(seed);
        this.ramming = ramming;
    }

    @Override
    public void setup(String line) {
        setup = JsonMapper.shared().readTree(line);
    }

    @Override
    public String turn(String line) {
        JsonNode frame = JsonMapper.shared().readTree(line);
        int player = setup.get("player").intValue();
        StringBuilder answer = new StringBuilder("{\"pods\":[");
        for (JsonNode pod : frame.get("pods")) {
            if (pod.get("player").intValue() == player) {
                answer.append(answer.charAt(answer.length() - 1) == '[' ? "" : ",").append(command(frame, pod));
            }
        }
        answer.append(']');
        if (random.nextInt(10) == 0) {
            answer.append(",\"message\":\"turn ").append(frame.get("turn").intValue()).append('"');
        }
        return answer.append('}').toString();
    }

    private String command(JsonNode frame, JsonNode pod) {
        JsonNode goal = setup.get("checkpoints").get(pod.get("nextCheckpoint").intValue());
        double x = goal.get("x").doubleValue() - 3 * pod.get("vx").doubleValue() + random.nextInt(-200, 200);
        double y = goal.get("y").doubleValue() - 3 * pod.get("vy").doubleValue() + random.nextInt(-200, 200);
        if (random.nextDouble() < ramming) {
            JsonNode victim = nearest(frame, pod);
            x = victim.get("x").doubleValue();
            y = victim.get("y").doubleValue();
        }
        switch (random.nextInt(40)) {
            case 0 -> {
                x = pod.get("x").doubleValue();
                y = pod.get("y").doubleValue();
            }
            case 1 -> x += random.nextDouble();
            default -> { }
        }
        String thrust = switch (random.nextInt(20)) {
            case 0 -> "\"shield\":true";
            case 1 -> "\"boost\":true";
            case 2 -> "\"thrust\":" + random.nextInt(0, 200);
            default -> "\"thrust\":200";
        };
        return "{\"x\":" + x + ",\"y\":" + y + "," + thrust + "}";
    }

    private static JsonNode nearest(JsonNode frame, JsonNode pod) {
        JsonNode nearest = pod;
        double least = Double.POSITIVE_INFINITY;
        for (JsonNode other : frame.get("pods")) {
            double dx = other.get("x").doubleValue() - pod.get("x").doubleValue();
            double dy = other.get("y").doubleValue() - pod.get("y").doubleValue();
            if (other.get("player").intValue() != pod.get("player").intValue() && dx * dx + dy * dy < least) {
                least = dx * dx + dy * dy;
                nearest = other;
            }
        }
        return nearest;
    }
}
