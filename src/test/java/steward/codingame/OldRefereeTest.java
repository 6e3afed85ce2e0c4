package steward.codingame;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import steward.game.GameSetup;
import steward.match.TestScenes;
import steward.match.TimeControl;

/** The referee whose tool starts the bots; here the tool has written all its lines beforehand. */
class OldRefereeTest {

    private static List<String> play(GameSetup setup, TimeControl time, String input) throws InterruptedException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        new OldReferee(setup, new ByteArrayInputStream(input.getBytes(StandardCharsets.UTF_8)), out)
            .play(time, () -> 7);
        return out.toString(StandardCharsets.UTF_8).lines().toList();
    }

    private static List<String> play(String input) throws InterruptedException {
        return play(TestScenes.open("mad-pod-racing"), TimeControl.UNLIMITED, input);
    }

    private static String last(List<String> lines) {
        return lines.get(lines.size() - 1);
    }

    @Test
    void setupAndFirstTurnAreOneInput() throws InterruptedException {
        List<String> lines = play("###Seed 5\n###Start 2\n1 1 1\n1 1 1\n");

        assertEquals("###Input 0", lines.get(0));
        assertEquals("3", lines.get(1));
        int checkpoints = Integer.parseInt(lines.get(2));
        assertEquals(6, lines.get(3 + checkpoints).split(" ").length);
        assertEquals("###Output 0 2", lines.get(7 + checkpoints));
        assertEquals("###Input 1", lines.get(8 + checkpoints));
        assertEquals("###Output 1 2", lines.get(15 + 2 * checkpoints));
    }

    @Test
    void theSeedMakesTheMap() throws InterruptedException {
        assertEquals(play("###Seed 7\n###Start 2\n"), play("###Start 2\n"));
        assertEquals(false, play("###Seed 8\n###Start 2\n").equals(play("###Start 2\n")));
    }

    @ParameterizedTest
    @CsvSource({
        "'',                                       ###End 1 0",
        "'1 1 1|',                                 ###End 1 0",
        "'1 1 1|1 1',                              ###End 1 0",
        "'1 1 1|1 1 1|',                           ###End 0 1",
        "'1 1 1|1 1 1|1 1 1|',                     ###End 0 1",
        "'1 1 1|1 1 1|1 1 1|1 1 1|',               ###End 1 0",
        "'x|x|1 1 1|1 1 1|',                       ###End 1 0",
        "'x|x|x|x|',                               ###End 01",
        "'x|x|',                                   ###End 01",
        "'1 1 1|1 1 1|x|x|',                       ###End 0 1"})
    void whoeverIsAskedWhenTheInputEndsHasFailed(String answers, String end) throws InterruptedException {
        assertEquals(end, last(play("###Start 2\r\n" + answers.replace('|', '\n'))));
    }

    @Test
    void threePlayersOfWhomOneWasNotAsked() throws InterruptedException {
        // One pod each. Player 0 answers nonsense, player 1 has gone, player 2 could not be asked.
        assertEquals("###End 2 01", last(play(TestScenes.duel(3), TimeControl.UNLIMITED, "###Start 3\nx\n")));
    }

    @Test
    void aDrawIsOneWord() throws InterruptedException {
        // No pod moves: both players are out after 51 turns without a checkpoint.
        String idle = "0 0 0\n".repeat(102);
        assertEquals("###End 01", last(play(TestScenes.duel(2), TimeControl.UNLIMITED, "###Start 2\n" + idle)));
    }

    @Test
    void whoIsLateHasFailed() throws InterruptedException {
        assertEquals("###End 01", last(play(TestScenes.duel(2), new TimeControl(1, 1), "###Start 2\n0 0 0\n0 0 0\n")));
    }

    @Test
    void aLineWithoutEndIsNotKept() throws InterruptedException {
        String long1 = "1".repeat(OldRefereeLines.LONGEST + 1);
        assertEquals("###End 1 0", last(play(TestScenes.duel(2), TimeControl.UNLIMITED,
            "###Start 2\n" + long1 + "\n0 0 0\n")));
    }

    @ParameterizedTest
    @CsvSource(delimiter = ';', value = {
        "''; the input ends after 0 lines, expected ###Start P",
        "###Seed 5|; the input ends after 1 lines, expected ###Start P",
        "###Seed x|; input line 1: found \"###Seed x\", expected a whole number of 64 bits after ###Seed",
        "###Seed 1|###Start|; input line 2: found \"###Start\", expected ###Seed N or ###Start P",
        "###Start two|; input line 1: found \"###Start two\", expected a number of players after ###Start",
        "###Start 3|; input line 1: found \"###Start 3\", expected 2: the scene \"duel\" is for 2 players",
        "hello|; input line 1: found \"hello\", expected ###Seed N or ###Start P"})
    void aWrongStartIsToldWithItsLine(String input, String message) {
        assertEquals(message, assertThrows(IllegalArgumentException.class,
            () -> play(TestScenes.duel(2), TimeControl.UNLIMITED, input.replace('|', '\n'))).getMessage());
    }
}
