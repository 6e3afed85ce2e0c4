package steward.bots.meanmax;

import java.util.List;
import steward.bots.LineBot;
import tools.jackson.core.JsonParser;
import tools.jackson.core.JsonToken;

/** A bot for Mean Max. */
abstract class MeanMaxBot extends LineBot {

    private final Situation situation = new Situation();
    private final Orders orders = new Orders();

    MeanMaxBot() {
        super("mean-max");
    }

    /** Decides one turn: an order for the reaper, the destroyer and the doof, in this order. */
    abstract void decide(Situation now, Orders orders);

    @Override
    protected final String decide() {
        orders.begin();
        decide(situation, orders);
        return orders.answer();
    }

    @Override
    protected final void read(String field, JsonParser in) {
        switch (field) {
            case "player" -> situation.player = in.getIntValue();
            case "arenaRadius" -> situation.arenaRadius = in.getDoubleValue();
            case "scores" -> readNumbers(in, situation.scores);
            case "rages" -> readNumbers(in, situation.rages);
            case "units" -> readThings(in, situation.units);
            case "wrecks" -> readThings(in, situation.wrecks);
            case "effects" -> readThings(in, situation.effects);
            default -> in.skipChildren();
        }
    }

    private static void readThings(JsonParser in, List<Thing> things) {
        things.clear();
        while (in.nextToken() == JsonToken.START_OBJECT) {
            Thing thing = new Thing();
            while (in.nextToken() == JsonToken.PROPERTY_NAME) {
                String name = in.currentName();
                in.nextToken();
                switch (name) {
                    case "kind" -> thing.kind = in.getString();
                    case "skill" -> thing.skill = in.getString();
                    case "player" -> thing.player = in.getIntValue();
                    case "x" -> thing.x = in.getDoubleValue();
                    case "y" -> thing.y = in.getDoubleValue();
                    case "vx" -> thing.vx = in.getDoubleValue();
                    case "vy" -> thing.vy = in.getDoubleValue();
                    case "mass" -> thing.mass = in.getDoubleValue();
                    case "radius" -> thing.radius = in.getDoubleValue();
                    case "water" -> thing.water = in.getIntValue();
                    case "size" -> thing.size = in.getIntValue();
                    default -> in.skipChildren();
                }
            }
            things.add(thing);
        }
    }
}
