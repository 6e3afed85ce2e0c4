package steward.replay.page;

import steward.bot.Bot;
import steward.bot.InProcessPlayer;
import steward.bot.Player;
import steward.bot.StderrPlayer;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/**
 * A pod-race bot for looking at matches: each pod steers at its next checkpoint and allows for its drift, boosts once
 * on a long straight and raises its shield when an opponent comes close. It says what it thinks, and draws it.
 */
final class PageTestBot implements Bot {

    private static final double NEAR = 1000;
    private static final double FAST = 450;

    private JsonNode setup;
    private int player;
    private int turn;
    private final StringBuilder notes = new StringBuilder();

    @Override
    public void setup(String line) {
        setup = JsonMapper.shared().readTree(line);
        player = setup.get("player").asInt();
    }

    @Override
    public String turn(String line) {
        JsonNode pods = JsonMapper.shared().readTree(line).get("pods");
        turn++;
        notes.setLength(0);
        StringBuilder answer = new StringBuilder("{\"pods\":[");
        String separator = "";
        for (JsonNode pod : pods) {
            if (pod.get("player").asInt() == player) {
                answer.append(separator).append(command(pod, pods));
                separator = ",";
            }
        }
        return answer.append("],\"message\":\"").append(turn % 20 < 10 ? "full speed" : "steady now")
            .append("\"}").toString();
    }

    /** Returns its text on stderr in the last turn. */
    String notes() {
        return notes.toString();
    }

    private String command(JsonNode pod, JsonNode pods) {
        JsonNode checkpoint = setup.get("checkpoints").get(pod.get("nextCheckpoint").asInt());
        double x = pod.get("x").asDouble();
        double y = pod.get("y").asDouble();
        long targetX = Math.round(checkpoint.get("x").asDouble() - 3 * pod.get("vx").asDouble());
        long targetY = Math.round(checkpoint.get("y").asDouble() - 3 * pod.get("vy").asDouble());
        double distance = Math.hypot(checkpoint.get("x").asDouble() - x, checkpoint.get("y").asDouble() - y);
        notes.append("pod ").append(pod.get("id")).append(": ").append(Math.round(distance)).append(" u to go\n")
            .append("@line ").append(x).append(' ').append(y).append(' ').append(targetX).append(' ').append(targetY)
            .append(" #8899aa\n@circle ").append(targetX).append(' ').append(targetY).append(" 120 gold\n");
        String thrust = "\"thrust\":" + thrust(pod, distance);
        if (isThreatened(pod, pods)) {
            thrust = "\"shield\":true";
        } else if (pod.get("boostLeft").asBoolean() && turn > 8 && distance > 5500) {
            thrust = "\"boost\":true";
            notes.append("@text ").append(x).append(' ').append(y - 700).append(" boost!\n");
        }
        return "{\"x\":" + targetX + ",\"y\":" + targetY + "," + thrust + "}";
    }

    /** Odd pods are the careful ones: they brake before a checkpoint. */
    private int thrust(JsonNode pod, double distance) {
        int maximum = setup.get("maximumThrust").asInt();
        return distance < 1500 && pod.get("id").asInt() % 2 == 1 ? maximum / 2 : maximum;
    }

    /** True if an opponent will be near in two turns and comes fast. */
    private boolean isThreatened(JsonNode pod, JsonNode pods) {
        for (JsonNode other : pods) {
            double vx = other.get("vx").asDouble() - pod.get("vx").asDouble();
            double vy = other.get("vy").asDouble() - pod.get("vy").asDouble();
            double dx = other.get("x").asDouble() - pod.get("x").asDouble() + vx;
            double dy = other.get("y").asDouble() - pod.get("y").asDouble() + vy;
            if (other.get("player").asInt() != player && pod.get("shieldTimer").asInt() == 0
                && Math.hypot(dx, dy) < NEAR && Math.hypot(vx, vy) > FAST) {
                return true;
            }
        }
        return false;
    }

    /** A player whose stderr is what the bot notes. */
    static Player player(String name, PageTestBot bot) {
        return new StderrPlayer(new InProcessPlayer(name, bot), turn -> bot.notes());
    }
}
