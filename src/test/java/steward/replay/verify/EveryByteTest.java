package steward.replay.verify;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.bot.Bot;
import steward.bot.TestBots;
import steward.match.SeededBot;
import steward.match.TestScenes;
import steward.match.TestSize;
import steward.numerics.SplitMix64;
import steward.replay.Recorded;
import steward.replay.ReplayException;
import steward.replay.sign.SigningKey;
import steward.scene.json.SceneException;

/**
 * A small match of four turns with impacts, messages beyond ASCII and a fault: every byte of its replay is altered, one
 * at a time, twice; and some are taken away or doubled. Only the bytes within {@code times} are free.
 */
@Execution(ExecutionMode.CONCURRENT)
class EveryByteTest {

    private static Recorded match(SigningKey key) {
        Bot talker = TestBots.byTurn(turn -> turn == 4 ? "\u00e4\uD83D\uDE00"
            : "{\"pods\":[{\"x\":5500.5,\"y\":3000,\"boost\":true}],\"message\":\"\u00e4\uD83D\uDE00\"}");
        return Recorded.of(TestScenes.open("duel"), 3, List.of(talker, new SeededBot(3, 1)), key);
    }

    /** Within the braces of {@code times}, which are the last of their lines. */
    private static boolean[] free(String replay) {
        boolean[] free = new boolean[replay.getBytes(StandardCharsets.UTF_8).length];
        int from = 0;
        for (String line : replay.lines().toList()) {
            int to = from + line.getBytes(StandardCharsets.UTF_8).length;
            int times = line.lastIndexOf(",\"times\":{");
            if (times >= 0) {
                int first = from + line.substring(0, times).getBytes(StandardCharsets.UTF_8).length;
                Arrays.fill(free, first + ",\"times\":{".length(), to - 2, true);
            }
            from = to + 1;
        }
        return free;
    }

    private static boolean passes(byte[] replay) {
        try {
            return Recorded.verify(replay).verified();
        } catch (ReplayException | SceneException refusal) {
            assertTrue(refusal.getMessage().startsWith("r.jsonl"), refusal.getMessage());
            return false;
        }
    }

    private static byte[] replaced(byte[] replay, int at, int with) {
        byte[] edited = replay.clone();
        edited[at] = (byte) with;
        return edited;
    }

    private static byte[] without(byte[] replay, int at) {
        byte[] edited = Arrays.copyOf(replay, replay.length - 1);
        System.arraycopy(replay, at + 1, edited, at, edited.length - at);
        return edited;
    }

    private static byte[] doubled(byte[] replay, int at) {
        byte[] edited = Arrays.copyOf(replay, replay.length + 1);
        System.arraycopy(replay, at, edited, at + 1, replay.length - at);
        return edited;
    }

    private static void check(Recorded match, int step) {
        byte[] replay = match.bytes();
        boolean[] free = free(match.text());
        assertTrue(match.verify().verified());
        assertTrue(match.text().contains("\"impacts\"") && match.text().contains("\"faults\""), match.text());
        List<Integer> places = new ArrayList<>(IntStream.range(0, replay.length).filter(at -> !free[at]).boxed()
            .filter(at -> at % step == 0).toList());
        assertTrue(places.size() * step > 3500, "places: " + places.size());
        List<String> passed = places.parallelStream().flatMap(at -> {
            SplitMix64 random = new SplitMix64(at);
            List<String> here = new ArrayList<>();
            int other = replay[at] + random.nextInt(1, 255);
            if (passes(replaced(replay, at, replay[at] ^ 1))) {
                here.add(at + " flipped");
            }
            if (passes(replaced(replay, at, other))) {
                here.add(at + " made " + (byte) other);
            }
            boolean last = at == replay.length - 1;               // a line end that is lost loses nothing
            if (at % 7 == 0 && !last && passes(without(replay, at))) {
                here.add(at + " taken away");
            }
            if (at % 7 == 1 && passes(doubled(replay, at))) {
                here.add(at + " doubled");
            }
            return here.stream();
        }).toList();
        assertEquals(List.of(), passed);
    }

    @Test
    @Tag("campaign")
    void ofAnUnsignedReplay() {
        check(match(null), 1);
    }

    @Test
    @Tag("sized")
    void someOfAnUnsignedReplay() {
        check(match(null), TestSize.of(39, 13));
    }

    @Test
    @Tag("sized")
    void ofASignedReplay() {
        check(match(SigningKey.generate()), TestSize.of(30, 6));
    }

    /** Bytes within {@code times} may be altered. */
    @Test
    void withinTimesAnythingMayStand() {
        Recorded match = match(SigningKey.generate());
        boolean[] free = free(match.text());
        int digit = IntStream.range(0, free.length).filter(at -> free[at] && Character.isDigit(match.bytes()[at]))
            .findFirst().orElseThrow();
        assertTrue(passes(replaced(match.bytes(), digit, match.bytes()[digit] == '7' ? '8' : '7')));
    }
}
