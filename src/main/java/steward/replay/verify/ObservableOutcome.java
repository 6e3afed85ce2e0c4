package steward.replay.verify;

import steward.game.FrameCodec;
import steward.game.Game;
import steward.json.JsonNumbers;
import steward.json.JsonObject;
import steward.physics.Impact;
import steward.physics.TurnLog;
import tools.jackson.core.JsonGenerator;

/**
 * Outcome of a turn just played as another referee can have observed it, in the form in which it records it: places of
 * impacts rounded, half the sum of both velocities before, rounded, in place of the velocities; the ranks as they
 * stand.
 */
final class ObservableOutcome {

    /**
     * Fields of an outcome; the caller opens and closes the object.
     *
     * @param compared says which times and impulses stand for ours
     */
    static void write(JsonGenerator out, Game game, FrameCodec codec, ImpactComparison compared) {
        TurnLog log = game.log();
        if (log.impacts() > 0) {
            JsonObject.writeEach(out, "impacts", log.kept(), k ->
                write(out, log.impact(k), compared.time(k), compared.impulse(k)));
        }
        out.writeObjectPropertyStart("state");
        codec.state().writeState(out);
        out.writeEndObject();
        int[] ranks = game.ranks();
        JsonNumbers.writeAll(out, "ranks", ranks.length, player -> ranks[player]);
    }

    private static void write(JsonGenerator out, Impact impact, double time, double impulse) {
        out.writeStartObject();
        JsonNumbers.write(out, "time", time);
        out.writeNumberProperty("a", impact.a());
        if (impact.isWall()) {
            out.writeNumberProperty("wall", impact.wall());
        } else {
            out.writeNumberProperty("b", impact.b());
        }
        out.writeNumberProperty("ax", Math.round(impact.ax()));
        out.writeNumberProperty("ay", Math.round(impact.ay()));
        out.writeNumberProperty("bx", Math.round(impact.bx()));
        out.writeNumberProperty("by", Math.round(impact.by()));
        JsonNumbers.write(out, "impulse", impulse);
        out.writeNumberProperty("meanVx", Math.round((impact.vaxBefore() + impact.vbxBefore()) / 2));
        out.writeNumberProperty("meanVy", Math.round((impact.vayBefore() + impact.vbyBefore()) / 2));
        out.writeEndObject();
    }
}
