package steward.cli.replay;

import java.util.List;
import steward.json.JsonObject;
import steward.match.MatchResult;
import steward.replay.feed.FedTurn;
import steward.replay.feed.Takeover;
import tools.jackson.core.JsonGenerator;

/** Result of {@code steward feed} for programs: one JSON object. */
final class FeedJson {

    /**
     * Fields of the object.
     *
     * @param compared  how many turns were compared
     * @param differing those of them that differ
     */
    static void write(JsonGenerator out, FeedSession session, int compared, List<FedTurn> differing) {
        out.writeNumberProperty("player", session.player());
        out.writeStringProperty("name", session.match().header().names().get(session.player()));
        out.writeStringProperty("bot", session.bot().toString());
        out.writeStringProperty("protocol", session.protocol().word());
        out.writeNumberProperty("compared", compared);
        out.writeNumberProperty("same", compared - differing.size());
        JsonObject.writeAll(out, "differing", differing, turn -> {
            out.writeNumberProperty("turn", turn.number());
            out.writeStringProperty("recordedFault", turn.recordedFault());
            out.writeStringProperty("fault", turn.fault());
            JsonObject.writeAll(out, "fields", turn.differences(), difference -> {
                out.writeStringProperty("field", difference.field());
                out.writeStringProperty("recorded", difference.recorded());
                out.writeStringProperty("now", difference.found());
            });
        });
    }

    /**
     * The field {@code played}: the result of letting the bot play; null if it did not.
     *
     * @param turns that the bot has played
     * @param file  of the new replay
     */
    static void write(JsonGenerator out, Takeover.Outcome outcome, int turns, String file) {
        if (outcome == null) {
            out.writeNullProperty("played");
            return;
        }
        MatchResult result = outcome.result();
        out.writeObjectPropertyStart("played");
        out.writeNumberProperty("turns", turns);
        out.writeNumberProperty("turnsInAll", outcome.turns());
        out.writeStringProperty("ending", result == null ? null : result.ending());
        out.writeStringProperty("noResultBecause", outcome.reason());
        JsonObject.writeTexts(out, "ahead", outcome.ahead());
        out.writeStringProperty("replay", file);
        out.writeEndObject();
    }
}
