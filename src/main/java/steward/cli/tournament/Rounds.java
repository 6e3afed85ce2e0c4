package steward.cli.tournament;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;
import steward.files.InputException;
import steward.files.OutputFiles;
import steward.json.JsonObject;
import steward.report.Fields;
import steward.scene.json.Block;
import steward.scene.json.JsonTree;
import steward.scene.json.SceneException;
import steward.text.TextFormat;

/**
 * Pairings of programs in the rounds of a Swiss tournament. A round is decided when the one before is over: the first
 * of the table meets the next one below that it has not met, and so on. A program that is left over, from below, has a
 * bye; nobody has a second bye before all have had one. A round is written to {@code rounds.json} before its first
 * game. The file holds for the versions that it names: with others the rounds begin anew.
 *
 * @param file   where they are kept
 * @param field  the programs with the numbers of their versions
 * @param rounds so far; each is a list of groups, by names; a group that is too small has a bye
 */
record Rounds(Path file, List<String> field, List<List<List<String>>> rounds) {

    private static final String FIELD = "field";
    private static final String ROUNDS = "rounds";
    private static final String GROUPS = "groups";
    /** Choices that are tried for a round in which nobody meets again. */
    private static final int MOST_TRIES = 100_000;

    /**
     * Reads the rounds of these versions; none if there are none of them.
     *
     * @param told is told if there are rounds of others, which are given up
     * @throws InputException if the file cannot be used
     */
    static Rounds read(Path file, List<String> field, Consumer<String> told) {
        List<List<List<String>>> rounds = new ArrayList<>();
        if (Files.isRegularFile(file)) {
            try {
                Block root = new Block(file.toString(), "", JsonTree.read(Files.readString(file), file.toString(),
                    "rounds of a tournament"));
                List<String> earlier = root.texts(FIELD);
                for (Block round : root.blocks(ROUNDS)) {
                    rounds.add(groups(round, earlier));
                }
                if (!earlier.equals(field)) {
                    told.accept("the programs are not those of the " + TextFormat.count(rounds.size(), "round")
                        + " so far: the rounds begin anew; games between versions that are still there count where "
                        + "they meet again");
                    rounds.clear();
                }
            } catch (IOException | SceneException problem) {
                throw new InputException(problem instanceof IOException ? file + ": cannot be read: "
                    + OutputFiles.reason(file, (IOException) problem) : problem.getMessage()
                    + "; without the file the rounds begin anew");
            }
        }
        return new Rounds(file, field, rounds);
    }

    /** The groups of a round, in which each program of the field is once. */
    private static List<List<String>> groups(Block round, List<String> field) {
        List<List<String>> groups = round.texts(GROUPS).stream().map(group -> List.of(group.split(" "))).toList();
        List<String> named = groups.stream().flatMap(List::stream).sorted().toList();
        List<String> expected = field.stream().map(version -> version.replaceFirst("#.*", "")).sorted().toList();
        if (!named.equals(expected)) {
            throw round.error(GROUPS, String.join(", ", named), "each program of the field once: "
                + String.join(", ", expected));
        }
        return groups;
    }

    private void write() throws IOException {
        OutputFiles.replace(file, JsonObject.of(Fields.of(FIELD, field, ROUNDS, Fields.each(rounds, round -> Fields.of(
            GROUPS, Fields.each(round, group -> String.join(" ", group)))))::write));
    }

    /** Number of decisions on each group. */
    Map<Set<String>, Integer> met() {
        Map<Set<String>, Integer> met = new HashMap<>();
        rounds.forEach(round -> round.forEach(group -> met.merge(new HashSet<>(group), 1, Integer::sum)));
        return met;
    }

    /** Number of byes of each program. */
    Map<String, Integer> byes(int players) {
        Map<String, Integer> byes = new HashMap<>();
        rounds.forEach(round -> round.stream().filter(group -> group.size() < players)
            .forEach(group -> group.forEach(name -> byes.merge(name, 1, Integer::sum))));
        return byes;
    }

    /**
     * Decides on the next round and writes it.
     *
     * @param standing names, best first
     * @param players  of a game
     */
    void decide(List<String> standing, int players) throws IOException {
        Map<String, Integer> byes = byes(players);
        List<String> left = new ArrayList<>(standing);
        List<List<String>> round = new ArrayList<>();
        List<List<String>> without = new ArrayList<>();
        for (int k = standing.size() % players; k > 0; k--) {
            int fewest = left.stream().mapToInt(name -> byes.getOrDefault(name, 0)).min().orElse(0);
            String last = left.stream().filter(name -> byes.getOrDefault(name, 0) == fewest)
                .reduce((one, other) -> other).orElseThrow();
            left.remove(last);
            without.add(List.of(last));
        }
        Map<Set<String>, Integer> pairs = pairs();
        if (players > 2 || !pair(left, pairs, round, new int[] {MOST_TRIES})) {
            round.clear();
            round.addAll(nearest(left, pairs, players));
        }
        round.addAll(without);
        rounds.add(round);
        write();
    }

    /** Number of meetings of each two, in groups of any size. */
    private Map<Set<String>, Integer> pairs() {
        Map<Set<String>, Integer> pairs = new HashMap<>();
        met().forEach((group, times) -> group.forEach(one -> group.stream().filter(other -> !other.equals(one))
            .forEach(other -> pairs.merge(Set.of(one, other), times, Integer::sum))));
        return pairs;
    }

    /** Pairs the first with the next whom it has not met, such that the others can be paired too. */
    private static boolean pair(List<String> left, Map<Set<String>, Integer> met, List<List<String>> round,
                                int[] tries) {
        if (left.isEmpty()) {
            return true;
        }
        String first = left.get(0);
        for (int k = 1; k < left.size() && tries[0]-- > 0; k++) {
            if (!met.containsKey(Set.of(first, left.get(k)))) {
                List<String> rest = new ArrayList<>(left);
                rest.remove(k);
                rest.remove(0);
                round.add(List.of(first, left.get(k)));
                if (pair(rest, met, round, tries)) {
                    return true;
                }
                round.remove(round.size() - 1);
            }
        }
        return false;
    }

    /** Groups the first with those whom its group has met least, the nearest first. */
    private static List<List<String>> nearest(List<String> standing, Map<Set<String>, Integer> met, int players) {
        List<String> left = new ArrayList<>(standing);
        List<List<String>> round = new ArrayList<>();
        while (!left.isEmpty()) {
            List<String> group = new ArrayList<>(List.of(left.remove(0)));
            while (group.size() < players) {
                String next = left.stream().min(Comparator.comparingInt(name -> group.stream().mapToInt(other ->
                    met.getOrDefault(Set.of(name, other), 0)).sum())).orElseThrow();
                group.add(next);
                left.remove(next);
            }
            round.add(List.copyOf(group));
        }
        return round;
    }

    /** A round in words. @param number from 1 */
    String text(int number, int players) {
        List<List<String>> round = rounds.get(number - 1);
        List<String> byes = round.stream().filter(group -> group.size() < players).map(group -> group.get(0)).toList();
        return "Round " + number + ": " + String.join(", ", round.stream().filter(group -> group.size() == players)
            .map(group -> String.join(" - ", group)).toList())
            + (byes.isEmpty() ? "" : "; a bye for " + String.join(", ", byes));
    }
}
