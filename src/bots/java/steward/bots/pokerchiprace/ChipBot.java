package steward.bots.pokerchiprace;

import java.io.BufferedReader;
import java.io.FileDescriptor;
import java.io.FileInputStream;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import tools.jackson.core.JsonParser;
import tools.jackson.core.JsonToken;
import tools.jackson.core.ObjectReadContext;
import tools.jackson.core.json.JsonFactory;

/**
 * A bot for the Poker Chip Race that uses JSON lines: a setup line, then a line per turn, each answered with one line,
 * then an end line. An answer follows from the setup and the turn alone.
 */
abstract class ChipBot {

    /** Up to this radius a chip cannot push itself, in u. */
    static final double SMALL = 5;
    /** Half the width of the table, in u. */
    static final double HALF_WIDTH = 400;
    /** Half the height of the table, in u. */
    static final double HALF_HEIGHT = 257.5;

    private static final String GAME = "poker-chip-race";

    /** The number of this player. */
    int player;
    /** All chips in play. */
    final List<Chip> chips = new ArrayList<>();

    private final JsonFactory json = new JsonFactory();
    private final List<Integer> own = new ArrayList<>();

    /** Decides for one chip: the direction (x, y) of a push, or {@code null} to wait. */
    abstract double[] decide(Chip chip);

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
                    case "player" -> player = in.getIntValue();
                    case "own" -> readOwn(in);
                    case "chips" -> readChips(in);
                    default -> in.skipChildren();
                }
            }
        }
        return turn ? answer() : null;
    }

    private String answer() {
        StringBuilder line = new StringBuilder("{\"chips\":[");
        for (int id : own) {
            Chip chip = chips.stream().filter(one -> one.id == id).findFirst().orElseThrow();
            double[] push = chip.radius <= SMALL ? null : decide(chip);
            line.append(line.charAt(line.length() - 1) == '[' ? "" : ",");
            if (push == null) {
                line.append("{\"wait\":true}");
            } else {
                line.append("{\"x\":").append(chip.x + push[0]).append(",\"y\":").append(chip.y + push[1]).append('}');
            }
        }
        return line.append("]}").toString();
    }

    private static void requireGame(String game) {
        if (!game.equals(GAME)) {
            throw new IllegalArgumentException("this bot plays " + GAME + ", not " + game);
        }
    }

    private void readOwn(JsonParser in) {
        own.clear();
        while (in.nextToken() != JsonToken.END_ARRAY) {
            own.add(in.getIntValue());
        }
    }

    private void readChips(JsonParser in) {
        chips.clear();
        while (in.nextToken() == JsonToken.START_OBJECT) {
            Chip chip = new Chip();
            while (in.nextToken() == JsonToken.PROPERTY_NAME) {
                String name = in.currentName();
                in.nextToken();
                switch (name) {
                    case "id" -> chip.id = in.getIntValue();
                    case "player" -> chip.player = in.getIntValue();
                    case "radius" -> chip.radius = in.getDoubleValue();
                    case "x" -> chip.x = in.getDoubleValue();
                    case "y" -> chip.y = in.getDoubleValue();
                    case "vx" -> chip.vx = in.getDoubleValue();
                    case "vy" -> chip.vy = in.getDoubleValue();
                    default -> in.skipChildren();
                }
            }
            chips.add(chip);
        }
    }
}
