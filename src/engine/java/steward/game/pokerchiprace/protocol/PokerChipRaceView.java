package steward.game.pokerchiprace.protocol;

import java.math.BigDecimal;
import java.math.RoundingMode;
import steward.game.Game;
import steward.game.ServerView;
import steward.game.StateCodec;
import steward.game.pokerchiprace.ChipTable;
import steward.game.pokerchiprace.PokerChipRace;
import steward.json.JsonNumbers;
import steward.json.JsonObject;
import steward.physics.Bodies;
import steward.text.ViewLines;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.io.NumberOutput;

/**
 * Reads the server's views of the Poker Chip Race: the chips after a turn with owner, radius and place, radius and
 * place with two digits behind the point, and the scores. Speeds are not shown. Points of paths, and the angles by
 * which the site turns its pictures, are not read.
 */
final class PokerChipRaceView implements ServerView {

    private static final int DIGITS = 2;

    @Override
    public String title() {
        return "PokerChipRace";
    }

    @Override
    public Shown open(ViewLines first, String input, int players) {
        return new PokerChipRaceShown(first, input);
    }

    @Override
    public void writeShown(JsonGenerator out, Game game, StateCodec state) {
        state.writeProgress(out);
        out.writeObjectPropertyStart("state");
        writeShownStart(out, game, state);
        out.writeEndObject();
    }

    @Override
    public void writeShownStart(JsonGenerator out, Game game, StateCodec state) {
        PokerChipRace of = (PokerChipRace) game;
        Bodies bodies = of.bodies();
        JsonObject.writeEach(out, "bodies", bodies.size(), chip ->
            write(out, new Chip(bodies.id(chip), of.ownerOf(chip), rounded(bodies.radius[chip]),
                rounded(bodies.x[chip] + ChipTable.HALF_WIDTH), rounded(bodies.y[chip] + ChipTable.HALF_HEIGHT))));
    }

    /**
     * A chip as it is shown.
     *
     * @param owner {@link ChipTable#NEUTRAL} for none
     * @param x     from the corner of the table
     * @param y     likewise
     */
    record Chip(int id, int owner, double radius, double x, double y) { }

    /** With its place as ours are counted, from the middle of the table. */
    static void write(JsonGenerator out, Chip chip) {
        out.writeStartObject();
        out.writeNumberProperty("id", chip.id);
        if (chip.owner != ChipTable.NEUTRAL) {
            out.writeNumberProperty("player", chip.owner);
        }
        JsonNumbers.write(out, "radius", chip.radius);
        JsonNumbers.write(out, "x", rounded(chip.x - ChipTable.HALF_WIDTH) + 0.0);
        JsonNumbers.write(out, "y", rounded(chip.y - ChipTable.HALF_HEIGHT) + 0.0);
        out.writeEndObject();
    }

    /** Two digits, halves of the shortest decimal away from zero, as the server writes them. */
    private static double rounded(double value) {
        return new BigDecimal(NumberOutput.toString(value, true)).setScale(DIGITS, RoundingMode.HALF_UP).doubleValue();
    }
}
