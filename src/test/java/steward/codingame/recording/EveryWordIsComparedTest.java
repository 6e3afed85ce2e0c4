package steward.codingame.recording;

import org.junit.jupiter.api.Tag;

/** Every number and word of the frames of a turn of the server, changed one at a time. */
@Tag("campaign")
class EveryWordIsComparedTest extends WordsAreComparedTest {

    @Override
    int step() {
        return 1;
    }
}
