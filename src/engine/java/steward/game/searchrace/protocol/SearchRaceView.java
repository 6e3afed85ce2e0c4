package steward.game.searchrace.protocol;

import steward.game.Game;
import steward.game.ServerView;
import steward.game.StateCodec;
import steward.text.ViewLines;
import tools.jackson.core.JsonGenerator;
import tools.jackson.databind.JsonNode;

/** Reads the server's views of the search race; they have no title, but checkpoints with tooltips. */
final class SearchRaceView implements ServerView {

    @Override
    public String title() {
        return "Search Race";
    }

    @Override
    public boolean isOf(ViewLines first) {
        JsonNode frame = GraphicsLines.json(first.line(1));
        return frame != null && !SearchRaceShown.places(frame).isEmpty();
    }

    @Override
    public Shown open(ViewLines first, String input, int players) {
        return new SearchRaceShown(first, input);
    }

    @Override
    public void writeShown(JsonGenerator out, Game game, StateCodec state) {
        out.writeObjectPropertyStart("state");
        state.writeState(out);
        out.writeEndObject();
    }
}
