package steward.codingame;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import steward.match.MatchResult;
import steward.match.MatchResult.PlayerResult;

/** Scores from ranks and faults: a letter F after a rank is a fault. */
class GameResultScoresTest {

    @ParameterizedTest
    @CsvSource({
        "0 1,          1 0",
        "1 0,          0 1",
        "0 0,          0 0",
        "0 1F,         1 -1",
        "1F 0,         -1 1",
        "0F 0F,        -1 -1",
        "0F 1F,        -1 -2",
        "1F 0F,        -2 -1",
        "0 1 2 3,      3 2 1 0",
        "0 1 1 3,      3 1 1 0",
        "2F 0 3F 1,    -1 3 -2 2",
        "0 2F 1F 3F,   3 -2 -1 -3",
        "0 2F 1 2F,    3 -1 2 -1",
        "0 1F 2,       2 -1 -2",
        "0 0F,         -1 -1",
        "0,            0",
        "0F,           -1"})
    void followTheRanks(String ranks, String scores) {
        List<PlayerResult> players = new ArrayList<>();
        for (String rank : ranks.split(" ")) {
            boolean fault = rank.endsWith("F");
            players.add(new PlayerResult("x", rank.charAt(0) - '0', 0, fault ? "late" : null, fault ? "late" : null,
                1, 1, 1, 1, 0));
        }
        int[] found = GameResultScores.of(new MatchResult(1, "over", players));
        assertEquals(scores, String.join(" ", Arrays.stream(found).mapToObj(Integer::toString).toList()));
        for (PlayerResult one : players) {
            for (PlayerResult other : players) {
                assertEquals(Integer.signum(other.rank() - one.rank()),
                    Integer.compare(found[players.indexOf(one)], found[players.indexOf(other)]));
            }
        }
    }
}
