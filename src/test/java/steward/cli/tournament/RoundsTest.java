package steward.cli.tournament;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import steward.files.InputException;

/** Swiss rounds: who meets, who has a bye, and that they are kept. */
class RoundsTest {

    @TempDir
    private Path folder;

    private final List<String> told = new ArrayList<>();

    private Rounds rounds(String... field) {
        return Rounds.read(folder.resolve("rounds.json"), List.of(field), told::add);
    }

    private static List<String> names(int count) {
        return IntStream.range(0, count).mapToObj(k -> "bot" + k).toList();
    }

    /** By hand: a and b have met, so a meets c, and b the next one that is left. */
    @Test
    void theFirstMeetsTheNextWhomItHasNotMet() throws IOException {
        Rounds rounds = rounds("a", "b", "c", "d");
        rounds.decide(List.of("a", "b", "c", "d"), 2);
        rounds.decide(List.of("a", "b", "c", "d"), 2);
        assertEquals("Round 1: a - b, c - d", rounds.text(1, 2));
        assertEquals("Round 2: a - c, b - d", rounds.text(2, 2));
    }

    /** Four programs have three rounds. */
    @Test
    void inThreeRoundsOfFourEverybodyMeetsEverybody() throws IOException {
        Rounds rounds = rounds("a", "b", "c", "d");
        rounds.decide(List.of("c", "d", "a", "b"), 2);
        rounds.decide(List.of("a", "c", "b", "d"), 2);
        assertEquals("Round 2: a - c, b - d", rounds.text(2, 2));
        rounds.decide(List.of("a", "b", "c", "d"), 2);
        assertEquals("Round 3: a - d, b - c", rounds.text(3, 2));
    }

    /** In 2 to 9 programs nobody meets again and nobody has two byes, for as many rounds as that is possible at all. */
    @Test
    void nobodyMeetsAgainAndByesAreShared() throws IOException {
        Random random = new Random(7);
        for (int count = 2; count <= 9; count++) {
            Files.deleteIfExists(folder.resolve("rounds.json"));
            Rounds rounds = rounds(names(count).toArray(String[]::new));
            for (int number = 1; number <= count / 2; number++) {
                List<String> standing = new ArrayList<>(names(count));
                Collections.shuffle(standing, random);
                rounds.decide(standing, 2);
                Set<String> all = new HashSet<>();
                rounds.rounds().get(number - 1).forEach(all::addAll);
                assertEquals(Set.copyOf(standing), all);
            }
            String what = rounds.toString();
            assertTrue(rounds.met().values().stream().allMatch(times -> times == 1), what);
            assertEquals(count % 2 == 0 ? 0 : count / 2, rounds.byes(2).size(), what);
        }
    }

    @Test
    void moreRoundsThanOpponentsMeetAgain() throws IOException {
        Rounds rounds = rounds("a", "b");
        rounds.decide(List.of("a", "b"), 2);
        rounds.decide(List.of("b", "a"), 2);
        assertEquals(Map.of(Set.of("a", "b"), 2), rounds.met());
    }

    /** Seven programs in a game for three: one bye, and in the second round no group of the first. */
    @Test
    void inAGameForThreeThoseMeetWhoHaveMetLeast() throws IOException {
        Rounds rounds = rounds(names(7).toArray(String[]::new));
        rounds.decide(names(7), 3);
        rounds.decide(names(7), 3);
        assertEquals("Round 1: bot0 - bot1 - bot2, bot3 - bot4 - bot5; a bye for bot6", rounds.text(1, 3));
        assertEquals("Round 2: bot0 - bot3 - bot6, bot1 - bot4 - bot2; a bye for bot5", rounds.text(2, 3));
    }

    @Test
    void roundsAreKeptForTheirVersionsAlone() throws IOException {
        rounds("a", "b#2", "c").decide(List.of("a", "b", "c"), 2);
        assertEquals(List.of(List.of(List.of("a", "b"), List.of("c"))), rounds("a", "b#2", "c").rounds());
        assertEquals(List.of(), told);
        assertEquals(new HashMap<>(), rounds("a", "b#3", "c").met());
        assertEquals(List.of("the programs are not those of the 1 round so far: the rounds begin anew; games between "
            + "versions that are still there count where they meet again"), told);
        Files.writeString(folder.resolve("rounds.json"), "{\"field\":[\"a\"],\"rounds\":[{\"groups\":7}]}");
        assertTrue(assertThrows(InputException.class, () -> rounds("a")).getMessage().contains("rounds.json:1:"));
    }

    /** Cut anywhere, or with a letter changed, it is refused, and never read as other rounds. */
    @Test
    void aFileThatIsCutOrChangedIsRefused() throws IOException {
        Rounds rounds = rounds("a", "b#2", "c", "d");
        rounds.decide(List.of("a", "b", "c", "d"), 2);
        rounds.decide(List.of("a", "b", "c", "d"), 2);
        Path file = folder.resolve("rounds.json");
        String whole = Files.readString(file);
        int end = whole.stripTrailing().length();
        for (int length = 0; length < end; length++) {
            Files.writeString(file, whole.substring(0, length));
            InputException refused = assertThrows(InputException.class, () -> rounds("a", "b#2", "c", "d"));
            assertTrue(refused.getMessage().startsWith(file.toString())
                && refused.getMessage().endsWith("; without the file the rounds begin anew"), refused.getMessage());
        }
        Files.writeString(file, whole.replace("a c", "a b"));
        int column = whole.indexOf('[', whole.lastIndexOf("groups")) + 1;
        assertEquals(file + ":1:" + column + ": rounds[1].groups: found a, b, b, d, expected each program of the field "
            + "once: a, b, c, d; without the file the rounds begin anew",
            assertThrows(InputException.class, () -> rounds("a", "b#2", "c", "d")).getMessage());
        Files.writeString(file, whole);
        assertEquals(rounds.rounds(), rounds("a", "b#2", "c", "d").rounds());
        assertEquals(List.of(), told);
    }
}
