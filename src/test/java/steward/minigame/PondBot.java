package steward.minigame;

import steward.bot.Bot;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** Chases the nearest thing of a kind that it can eat. */
final class PondBot implements Bot {

    private static final JsonMapper JSON = JsonMapper.builder().build();

    private final String preferred;
    private int id;
    private double push;
    int setups;
    int ends;

    /** @param preferred the kind it likes best: hunter, cell, bubble or fog */
    PondBot(String preferred) {
        this.preferred = preferred;
    }

    @Override
    public void setup(String line) {
        JsonNode frame = JSON.readTree(line);
        id = frame.get("hunter").asInt();
        push = frame.get("push").asDouble();
        setups++;
    }

    @Override
    public String turn(String line) {
        JsonNode bodies = JSON.readTree(line).get("bodies");
        JsonNode me = null;
        for (JsonNode body : bodies) {
            me = body.get("id").asInt() == id ? body : me;
        }
        double bestX = 0;
        double bestY = 0;
        double best = Double.POSITIVE_INFINITY;
        for (JsonNode body : bodies) {
            double dx = body.get("x").asDouble() - me.get("x").asDouble();
            double dy = body.get("y").asDouble() - me.get("y").asDouble();
            boolean liked = body.get("kind").asString().equals(preferred);
            boolean eatable = body.get("mass").asDouble() * 1.25 <= me.get("mass").asDouble();
            double cost = Math.sqrt(dx * dx + dy * dy) * (liked ? 1 : 3) * (liked || eatable ? 1 : 10);
            if (body != me && cost < best) {
                best = cost;
                bestX = dx - 4 * me.get("vx").asDouble();
                bestY = dy - 4 * me.get("vy").asDouble();
            }
        }
        double length = Math.max(1, Math.sqrt(bestX * bestX + bestY * bestY));
        double share = 0.99 * push / length;
        return "{\"push\":{\"x\":" + bestX * share + ",\"y\":" + bestY * share + "},\"message\":\"" + preferred + "\"}";
    }

    @Override
    public void end(String line) {
        ends++;
    }
}
