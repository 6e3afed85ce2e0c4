package steward.cli.shared;

import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import steward.game.Game;
import steward.game.GameJson;
import steward.game.GameSetup;
import steward.game.Pilot;
import steward.numerics.SplitMix64;
import steward.scene.SceneFiles;

/**
 * A turn of every shipped scene allocates nothing once its buffers have grown, births, deaths, skills and passed
 * checkpoints included: counted by the JVM, to the byte.
 */
@Execution(ExecutionMode.CONCURRENT)
class GameAllocationTest {

    /** Scene whose turns take longer than all others. */
    private static final String LARGE_HEAP = "bowl";
    private static final int COUNTS = 5;
    private static final int COUNTS_ALONE = 2;
    private static final int LEAST_TURNS = 20;
    private static final int MOST_TURNS = 400;
    /** Turns, and counts above, of a scene without players: heaps of hundreds take long. */
    private static final int MOST_TURNS_ALONE = 80;
    /** Of so many turns in the second half of a game, one may be the first with so many impacts, events or things. */
    private static final int TURNS_PER_GROWTH = 20;
    /** In a heap that grows to the end of the game there are more contacts, and more lists that get longer. */
    private static final int TURNS_PER_GROWTH_OF_HEAPS = 10;

    private final ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();

    /**
     * One game is played every time, so that whatever a turn allocates shows in every count; the JVM's additions do
     * not. No more counts are needed once so few turns are left.
     */
    @ParameterizedTest
    @MethodSource("shortScenes")
    void aTurnAllocatesNothing(String scene) {
        assertNothingAllocated(scene);
    }

    @Test
    @Tag("campaign")
    void aTurnOfALargeHeapAllocatesNothing() {
        assertNothingAllocated(LARGE_HEAP);
    }

    static List<String> shortScenes() {
        return SceneFiles.shipped().stream().filter(scene -> !scene.equals(LARGE_HEAP)).toList();
    }

    private void assertNothingAllocated(String scene) {
        GameSetup setup = Games.open(scene);
        boolean alone = setup.scene().players() == 0;
        int most = alone ? MOST_TURNS_ALONE : MOST_TURNS;
        boolean[] allocates = new boolean[most];
        Arrays.fill(allocates, true);
        int counts = alone ? COUNTS_ALONE : COUNTS;
        int turns = 0;
        int grown = Integer.MAX_VALUE;
        int allowed = 0;
        for (int count = 0; count < counts && grown > allowed; count++) {
            boolean[] now = new boolean[most];
            turns = play(setup, now);
            grown = 0;
            for (int turn = turns / 2; turn < turns; turn++) {
                allocates[turn] &= now[turn];
                grown += allocates[turn] ? 1 : 0;
            }
            allowed = turns / 2 / (alone ? TURNS_PER_GROWTH_OF_HEAPS : TURNS_PER_GROWTH);
        }
        assertTrue(turns >= LEAST_TURNS, turns + " turns");
        assertTrue(grown <= allowed, grown + " of the last " + turns / 2 + " turns allocate");
    }

    /** @return how many turns were played, without the one that ends the game and puts its end into words */
    private int play(GameSetup setup, boolean[] allocates) {
        Game game = setup.create(1);
        GameJson codec = setup.codec(game);
        Pilot pilot = setup.pilot(Pilot.Aim.WIN);
        SplitMix64 random = new SplitMix64(1);
        while (true) {
            for (int player = 0; player < game.players(); player++) {
                if (game.isIn(player)) {
                    byte[] answer = pilot.answer(game, player, random).getBytes(StandardCharsets.UTF_8);
                    codec.readAnswer(player, answer, answer.length);
                }
            }
            long before = threads.getCurrentThreadAllocatedBytes();
            game.play();
            long allocated = threads.getCurrentThreadAllocatedBytes() - before;
            if (game.isOver() || game.turn() == allocates.length) {
                return game.turn() - 1;
            }
            allocates[game.turn() - 1] = allocated > 0;
        }
    }
}
