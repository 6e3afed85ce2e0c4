package steward.bots.pokerchiprace;

import java.util.ArrayList;
import java.util.List;
import steward.bots.LineBot;
import tools.jackson.core.JsonParser;
import tools.jackson.core.JsonToken;

/** A bot for the Poker Chip Race. */
abstract class ChipBot extends LineBot {

    /** Up to this radius a chip cannot push itself, in u. */
    static final double SMALL = 5;
    /** Half the width of the table, in u. */
    static final double HALF_WIDTH = 400;
    /** Half the height of the table, in u. */
    static final double HALF_HEIGHT = 257.5;

    /** The number of this player. */
    int player;
    /** All chips in play. */
    final List<Chip> chips = new ArrayList<>();

    private final List<Integer> own = new ArrayList<>();

    ChipBot() {
        super("poker-chip-race");
    }

    /** Decides for one chip: the direction (x, y) of a push, or {@code null} to wait. */
    abstract double[] decide(Chip chip);

    @Override
    protected final String decide() {
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

    @Override
    protected final void read(String field, JsonParser in) {
        switch (field) {
            case "player" -> player = in.getIntValue();
            case "own" -> readNumbers(in, own);
            case "chips" -> readChips(in);
            default -> in.skipChildren();
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
