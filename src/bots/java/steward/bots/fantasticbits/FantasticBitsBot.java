package steward.bots.fantasticbits;

import java.util.List;
import steward.bots.LineBot;
import tools.jackson.core.JsonParser;
import tools.jackson.core.JsonToken;

/** A bot for Fantastic Bits. */
abstract class FantasticBitsBot extends LineBot {

    private final Situation situation = new Situation();
    private final Orders orders = new Orders();

    FantasticBitsBot() {
        super("fantastic-bits");
    }

    /** Decides one turn: an order for each of the two wizards. */
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
            case "width" -> situation.width = in.getDoubleValue();
            case "height" -> situation.height = in.getDoubleValue();
            case "goal" -> readGoal(in);
            case "magic" -> readNumbers(in, situation.magic);
            case "entities" -> readEntities(in, situation.entities);
            default -> in.skipChildren();
        }
    }

    private void readGoal(JsonParser in) {
        while (in.nextToken() == JsonToken.PROPERTY_NAME) {
            String name = in.currentName();
            in.nextToken();
            switch (name) {
                case "x" -> situation.goalX = in.getDoubleValue();
                case "top" -> situation.goalTop = in.getDoubleValue();
                case "bottom" -> situation.goalBottom = in.getDoubleValue();
                default -> in.skipChildren();
            }
        }
    }

    private static void readEntities(JsonParser in, List<Entity> entities) {
        entities.clear();
        while (in.nextToken() == JsonToken.START_OBJECT) {
            Entity entity = new Entity();
            while (in.nextToken() == JsonToken.PROPERTY_NAME) {
                String name = in.currentName();
                in.nextToken();
                switch (name) {
                    case "id" -> entity.id = in.getIntValue();
                    case "kind" -> entity.kind = in.getString();
                    case "player" -> entity.player = in.getIntValue();
                    case "x" -> entity.x = in.getDoubleValue();
                    case "y" -> entity.y = in.getDoubleValue();
                    case "vx" -> entity.vx = in.getDoubleValue();
                    case "vy" -> entity.vy = in.getDoubleValue();
                    case "snaffle" -> entity.snaffle = in.getIntValue();
                    case "held" -> entity.held = in.getBooleanValue();
                    case "spells" -> readSpells(in, entity);
                    case "cast" -> readTarget(in, entity);
                    default -> in.skipChildren();
                }
            }
            entities.add(entity);
        }
    }

    /** A spell in its last turn is over before the next. */
    private static void readSpells(JsonParser in, Entity wizard) {
        while (in.nextToken() == JsonToken.START_OBJECT) {
            int before = wizard.spellTarget;
            if (readTarget(in, wizard) <= 1) {
                wizard.spellTarget = before;
            }
        }
    }

    private static int readTarget(JsonParser in, Entity wizard) {
        int turns = Integer.MAX_VALUE;
        while (in.nextToken() == JsonToken.PROPERTY_NAME) {
            String name = in.currentName();
            in.nextToken();
            switch (name) {
                case "turns" -> turns = in.getIntValue();
                case "target" -> wizard.spellTarget = in.getIntValue();
                default -> in.skipChildren();
            }
        }
        return turns;
    }
}
