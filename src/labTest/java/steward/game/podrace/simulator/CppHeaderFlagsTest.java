package steward.game.podrace.simulator;

import org.junit.jupiter.api.Tag;

/** The tests of the header for bots in C++ at length, with programs that are compiled by every flag. */
@Tag("campaign")
class CppHeaderFlagsTest extends CppHeaderTest {

    @Override
    boolean isCampaign() {
        return true;
    }
}
