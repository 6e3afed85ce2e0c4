package steward.game;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.function.Function;
import steward.json.JsonNumbers;
import steward.json.JsonObject;
import steward.match.TestScenes;
import tools.jackson.core.JsonParser;
import tools.jackson.core.ObjectReadContext;

/** Answers of a bot, as lines and as JSON, and the commands that a replay keeps of them. */
public abstract class GameAnswers<S extends GameSetup, G extends Game> {

    protected final S setup;
    protected final G game;
    protected final GameJson codec;
    protected final TextCodec text;
    private final int player;

    /**
     * @param scene  the name of a shipped scene
     * @param game   makes the game
     * @param player who answers
     */
    @SuppressWarnings("unchecked")
    protected GameAnswers(String scene, Function<S, G> game, int player) {
        setup = (S) TestScenes.open(scene);
        this.game = game.apply(setup);
        this.player = player;
        codec = setup.codec(this.game);
        text = setup.textCodec(this.game).orElseThrow();
    }

    /** Reads lines, which a slash separates. */
    protected final String lines(String lines) {
        return CodecText.read(text, player, lines.replace('/', '\n'));
    }

    /** Reads JSON with single quotes. */
    protected final String json(String line) {
        return CodecText.read(codec, player, line.replace('\'', '"'));
    }

    /** Returns the lines that the player is sent. */
    protected final String turn(boolean first) {
        return (first ? CodecText.setup(text, player) : "") + CodecText.turn(text, player);
    }

    /** Returns what a replay keeps of the last answer, with single quotes. */
    protected final String kept() {
        return new String(JsonObject.of(out -> {
            out.writeName("c");
            codec.writeCommand(out, player);
        }), StandardCharsets.UTF_8).replace('"', '\'');
    }

    /** Reads what a replay has kept, with single quotes. */
    protected final String read(String kept, boolean partial) {
        try (JsonParser in = JsonNumbers.FACTORY.createParser(ObjectReadContext.empty(),
                kept.replace('\'', '"').getBytes(StandardCharsets.UTF_8))) {
            in.nextToken();
            in.nextToken();
            in.nextToken();
            return partial ? codec.readPartialCommand(in, player) : codec.readCommand(in, player);
        }
    }

    /** Holds what is kept of the last answer to a text, and to what is kept once that was read. */
    protected final void assertKept(String expected, boolean partial) {
        assertEquals(expected, kept());
        codec.clearCommand(player);
        assertNull(read(expected, partial));
        assertEquals(expected, kept());
    }

    /** Refuses JSON. @param expected how the fault begins */
    protected final void assertWrong(String answer, String expected) {
        String wrong = json(answer);
        assertTrue(wrong != null && wrong.startsWith(expected), wrong);
    }
}
