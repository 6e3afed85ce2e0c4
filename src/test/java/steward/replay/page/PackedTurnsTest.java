package steward.replay.page;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;
import steward.match.TestScenes;
import steward.replay.Recorded;

/** Long replays as their pages hold them: beyond a size every k-th state, and nothing is played again. */
class PackedTurnsTest {

    private static final String SCENE = """
        { "name": "gas", "game": "bodies", "players": 0, "field": { "width": 1800, "height": 1800, "walls": "box" },
          "bodies": { "fill": { "shape": "lattice", "count": 100, "radius": 20, "speed": [0, 17] } },
          "play": { "maximumTurns": 300 }, "accuracy": { "advance": "event", "arithmetic": "double" } }
        """;
    static byte[] replay() {
        return Recorded.of(TestScenes.TYPES.open(SCENE, "gas.json"), 7, List.of()).bytes();
    }

    /** Half the size takes at least every second turn; the last one is always there. */
    @Test
    void beyondASizeEveryFewTurnsAreLeftOut() {
        byte[] replay = replay();
        String whole = PackedTurns.of(replay);
        assertTrue(unpacked(whole).contains("\"every\":1,"), "all turns");
        String half = PackedTurns.of(replay, whole.length() / 2);
        assertTrue(half.length() <= whole.length() / 2, () -> half.length() + " of " + whole.length());
        assertFalse(unpacked(half).contains("\"every\":1,"));
    }

    private static String unpacked(String text) {
        return new String(PageTestPages.unpacked(text), StandardCharsets.ISO_8859_1);
    }

    /** Two hundred bodies that rest take minutes to play, and a match of such must not be played for its page. */
    @Test
    void aMatchWithoutBotsIsNotPlayedAgain() {
        assertNull(SentFrames.of(replay(), "gas.jsonl", TestScenes.TYPES));
        byte[] race = PageTestRaces.play(PageTestRaces.scene("duel"), 5);
        assertNotNull(SentFrames.of(race, "race.jsonl", TestScenes.TYPES));
    }
}
