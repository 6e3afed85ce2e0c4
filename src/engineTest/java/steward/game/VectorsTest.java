package steward.game;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Function;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestReporter;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import steward.game.fantasticbits.FantasticBitsReplay;
import steward.game.meanmax.MeanMaxReplay;
import steward.game.podrace.vectors.PodRaceReplay;
import steward.game.pokerchiprace.PokerReplay;
import steward.game.searchrace.protocol.SearchRaceReplay;
import steward.match.TestSize;

/**
 * Whole matches of the published referees with correctly rounded sine and cosine: states, impacts, ends, faults and the
 * lines sent to bots, from the start and from every recorded state. The sample in {@code truth}, or a folder of the
 * same form: {@code gradle test --tests '*VectorsTest' -Psteward.vectors=FOLDER}.
 */
@Execution(ExecutionMode.CONCURRENT)
class VectorsTest {

    /** A game, and how its matches are played again. */
    enum Referee {
        POD_RACE("pod-race", PodRaceReplay::new),
        MEAN_MAX("mean-max", MeanMaxReplay::new),
        FANTASTIC_BITS("fantastic-bits", FantasticBitsReplay::new),
        POKER_CHIP_RACE("poker-chip-race", PokerReplay::new),
        SEARCH_RACE("search-race", SearchRaceReplay::new);

        private final String game;
        private final Function<VectorMatch, VectorReplay<?>> replay;

        Referee(String game, Function<VectorMatch, VectorReplay<?>> replay) {
            this.game = game;
            this.replay = replay;
        }
    }

    @ParameterizedTest
    @EnumSource
    @Tag("sized")
    void matchesAreReproducedToTheLastBit(Referee referee, TestReporter report) throws IOException {
        compare(report, referee, TestSize.isWhole() ? GroundTruth.VECTORS.files(referee.game, ".jsonl.gz")
            : GroundTruth.matches(referee.game));
    }

    private static void compare(TestReporter report, Referee referee, List<Path> files) {
        List<String> differences = new ArrayList<>();
        long values = 0;
        long impacts = 0;
        int turns = 0;
        for (Path file : files) {
            VectorMatch match = VectorMatch.read(file);
            for (Comparison found : List.of(referee.replay.apply(match).compareWhole(),
                    referee.replay.apply(match).compareTurnByTurn())) {
                values += found.values();
                impacts += found.impacts();
                differences.addAll(found.differences());
            }
            turns += match.turns().size();
        }
        GroundTruth.tell(report, referee.game + ": " + files.size() + " matches, " + turns + " turns, from the start "
            + "and one by one, " + impacts + " impacts, " + values + " values compared, " + differences.size()
            + " different");
        assertTrue(values > 0, "there are matches");
        assertEquals(List.of(), differences.stream().limit(20).toList());
    }

    /** The names and the SHA-256 of all files; a page beside them says what they are. */
    @Test
    void theSampleIsWhole() throws IOException, NoSuchAlgorithmException {
        Path root = GroundTruth.sample("");
        Map<String, String> listed = new TreeMap<>();
        for (String line : Files.readAllLines(root.resolve("sha256.txt"))) {
            listed.put(line.substring(66), line.substring(0, 64));
        }
        Map<String, String> found = new TreeMap<>();
        try (Stream<Path> files = Files.walk(root)) {
            for (Path file : files.filter(Files::isRegularFile).toList()) {
                String name = root.relativize(file).toString().replace('\\', '/');
                if (!name.equals("sha256.txt") && !name.equals("README.md")) {
                    found.put(name, HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256")
                        .digest(Files.readAllBytes(file))));
                }
            }
        }
        Set<String> wrong = new TreeSet<>(listed.keySet());
        wrong.addAll(found.keySet());
        wrong.removeIf(name -> Objects.equals(listed.get(name), found.get(name)));
        assertEquals(Set.of(), wrong, "missing, changed or not listed in sha256.txt");
        for (Referee referee : Referee.values()) {
            assertTrue(listed.keySet().stream().anyMatch(name -> name.startsWith(referee.game + "/")), referee.game);
        }
    }
}
