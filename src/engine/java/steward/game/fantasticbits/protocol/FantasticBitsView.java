package steward.game.fantasticbits.protocol;

import steward.game.Game;
import steward.game.ServerView;
import steward.game.StateCodec;
import steward.text.ViewLines;
import tools.jackson.core.JsonGenerator;

/** Reads the server's views of Fantastic Bits: all entities after a turn, scores and magic. */
final class FantasticBitsView implements ServerView {

    static final String TITLE = "Fantastic Bits";

    @Override
    public String title() {
        return TITLE;
    }

    @Override
    public Shown open(ViewLines first, String input, int players) {
        return new FantasticBitsShown(first, input);
    }

    @Override
    public void writeShown(JsonGenerator out, Game game, StateCodec state) {
        state.writeProgress(out);
        out.writeObjectPropertyStart("state");
        state.writeState(out);
        out.writeEndObject();
    }
}
