package steward.bots.meanmax;

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
 * A bot for Mean Max that uses JSON lines: a setup line, then a line per turn, each answered with one line, then an end
 * line. An answer follows from the setup and the turn alone.
 */
abstract class MeanMaxBot {

    private static final String GAME = "mean-max";

    private final JsonFactory json = new JsonFactory();
    private final Situation situation = new Situation();
    private final Orders orders = new Orders();

    /** Decides one turn: an order for the reaper, the destroyer and the doof, in this order. */
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
                    case "arenaRadius" -> situation.arenaRadius = in.getDoubleValue();
                    case "scores" -> readNumbers(in, situation.scores);
                    case "rages" -> readNumbers(in, situation.rages);
                    case "units" -> readThings(in, situation.units);
                    case "wrecks" -> readThings(in, situation.wrecks);
                    case "effects" -> readThings(in, situation.effects);
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

    private static void readNumbers(JsonParser in, List<Integer> numbers) {
        numbers.clear();
        while (in.nextToken() != JsonToken.END_ARRAY) {
            numbers.add(in.getIntValue());
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
