package steward.game.meanmax.protocol;

import java.math.BigDecimal;
import java.math.RoundingMode;
import steward.game.Game;
import steward.game.ServerView;
import steward.game.StateCodec;
import steward.game.TurnEvent;
import steward.game.meanmax.MeanMax;
import steward.json.JsonNumbers;
import steward.json.JsonObject;
import steward.physics.Impact;
import steward.physics.Motion;
import steward.text.ViewLines;
import tools.jackson.core.JsonGenerator;

/**
 * Reads the server's views of Mean Max: times of impacts with five digits behind the point, places and speeds of units
 * as they came into an impact, rounded to whole numbers; where and when tankers went; units, wrecks and effects after
 * the turn, and scores and rages. Speeds after a turn are shown before friction, which no state of ours has; a tanker
 * that has come is shown only from the next turn on.
 */
final class MeanMaxView implements ServerView {

    static final int DIGITS = 5;

    @Override
    public String title() {
        return "meanmax";
    }

    @Override
    public Shown open(ViewLines first, String input, int players) {
        return new MeanMaxShown(first, input);
    }

    @Override
    public void writeShown(JsonGenerator out, Game game, StateCodec state) {
        MeanMax of = (MeanMax) game;
        writeImpacts(out, of);
        int births = 0;
        out.writeArrayPropertyStart("events");
        for (TurnEvent event : of.events()) {
            births += event.kind() == TurnEvent.Kind.BIRTH ? 1 : 0;
            if (event.kind() == TurnEvent.Kind.DEATH) {
                writeDeath(out, rounded(event.time()), event.body(), whole(event.x()), whole(event.y()));
            }
        }
        out.writeEndArray();
        state.writeProgress(out);
        out.writeObjectPropertyStart("state");
        ((MeanMaxState) state).writeState(out, of.bodies().size() - births);
        out.writeEndObject();
    }

    private static void writeImpacts(JsonGenerator out, MeanMax game) {
        JsonObject.writeEach(out, "impacts", game.log().impacts(), k -> {
            Impact impact = game.log().impact(k);
            boolean wall = impact.isWall();
            writeImpact(out, rounded(impact.time()),
                new Met(impact.a(), whole(impact.ax()), whole(impact.ay()), whole(impact.vaxBefore()),
                    whole(impact.vayBefore())),
                wall ? null : new Met(impact.b(), whole(impact.bx()), whole(impact.by()), whole(impact.vbxBefore()),
                    whole(impact.vbyBefore())));
        });
    }

    /** A unit as it came into an impact. */
    record Met(int id, double x, double y, double vx, double vy) { }

    /** @param b {@code null} for the wall of the arena */
    static void writeImpact(JsonGenerator out, double time, Met a, Met b) {
        out.writeStartObject();
        JsonNumbers.write(out, "time", time);
        out.writeNumberProperty("a", a.id());
        if (b == null) {
            out.writeNumberProperty("wall", 0);
        } else {
            out.writeNumberProperty("b", b.id());
        }
        JsonNumbers.write(out, "ax", a.x());
        JsonNumbers.write(out, "ay", a.y());
        if (b != null) {
            JsonNumbers.write(out, "bx", b.x());
            JsonNumbers.write(out, "by", b.y());
        }
        JsonNumbers.write(out, "vax", a.vx());
        JsonNumbers.write(out, "vay", a.vy());
        if (b != null) {
            JsonNumbers.write(out, "vbx", b.vx());
            JsonNumbers.write(out, "vby", b.vy());
        }
        out.writeEndObject();
    }

    /** A tanker that was sunk or left. */
    static void writeDeath(JsonGenerator out, double time, int tanker, double x, double y) {
        out.writeStartObject();
        out.writeStringProperty("kind", "death");
        JsonNumbers.write(out, "time", time);
        out.writeNumberProperty("body", tanker);
        JsonNumbers.write(out, "x", x);
        JsonNumbers.write(out, "y", y);
        out.writeEndObject();
    }

    private static double rounded(double time) {
        return new BigDecimal(time).setScale(DIGITS, RoundingMode.HALF_UP).doubleValue();
    }

    /** Half away from zero, as the game rounds; never -0. */
    private static double whole(double value) {
        return Motion.roundHalfAway(value) + 0.0;
    }
}
