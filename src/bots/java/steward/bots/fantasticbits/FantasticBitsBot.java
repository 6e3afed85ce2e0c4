package steward.bots.fantasticbits;

import java.io.BufferedReader;
import java.io.FileDescriptor;
import java.io.FileInputStream;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import tools.jackson.core.JsonParser;
import tools.jackson.core.JsonToken;
import tools.jackson.core.ObjectReadContext;
import tools.jackson.core.json.JsonFactory;

/**
 * A bot for Fantastic Bits that uses JSON lines: a setup line, then a line per turn, each answered with one line, then
 * an end line. An answer follows from the setup and the turn alone.
 */
abstract class FantasticBitsBot {

    private static final String GAME = "fantastic-bits";

    private final JsonFactory json = new JsonFactory();
    private final Situation situation = new Situation();
    private final Orders orders = new Orders();

    /** Decides one turn: an order for each of the two wizards. */
    abstract void decide(Situation now, Orders orders);

    /** Plays one match over the standard streams. */
    final void run() throws IOException {
        BufferedReader in = new BufferedReader(
            new InputStreamReader(new FileInputStream(FileDescriptor.in), StandardCharsets.UTF_8));
        PrintStream out = System.out;
        for (String line = in.readLine(); line != null; line = in.readLine()) {
            String answer = answer(line);
            if (answer != null) {
                out.println(answer);
                out.flush();
            }
        }
    }

    /**
     * The answer to a frame, {@code null} if it wants none.
     *
     * @throws IllegalArgumentException if it is the setup of another game
     */
    final String answer(String line) {
        boolean turn = false;
        try (JsonParser in = json.createParser(ObjectReadContext.empty(), line)) {
            in.nextToken();
            while (in.nextToken() == JsonToken.PROPERTY_NAME) {
                String name = in.currentName();
                in.nextToken();
                switch (name) {
                    case "type" -> turn = in.getString().equals("turn");
                    case "game" -> requireGame(in.getString());
                    case "player" -> situation.player = in.getIntValue();
                    case "width" -> situation.width = in.getDoubleValue();
                    case "height" -> situation.height = in.getDoubleValue();
                    case "goal" -> readGoal(in);
                    case "magic" -> readNumbers(in, situation.magic);
                    case "entities" -> readEntities(in, situation.entities);
                    default -> in.skipChildren();
                }
            }
        }
        if (!turn) {
            return null;
        }
        orders.begin();
        decide(situation, orders);
        return orders.answer();
    }

    private static void requireGame(String game) {
        if (!game.equals(GAME)) {
            throw new IllegalArgumentException("this bot plays " + GAME + ", not " + game);
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

    private static void readNumbers(JsonParser in, List<Integer> numbers) {
        numbers.clear();
        while (in.nextToken() != JsonToken.END_ARRAY) {
            numbers.add(in.getIntValue());
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
