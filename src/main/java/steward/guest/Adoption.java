package steward.guest;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.EnumSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import steward.bot.isolation.Isolation;
import steward.guest.Block.Name;
import tools.jackson.core.util.DefaultIndenter;
import tools.jackson.core.util.DefaultPrettyPrinter;
import tools.jackson.core.util.Separators;
import tools.jackson.core.util.Separators.Spacing;
import tools.jackson.databind.json.JsonMapper;

/**
 * Adoption of a published referee: trial games with idle bots show which numbers of players and league levels there
 * are, what is the same when a game is played again, and whether classes can be kept from game to game. Bots say
 * {@code WAIT} and nothing else, so that what only others bring about is not seen.
 */
public final class Adoption {

    private static final long[] SEEDS = {1, 2, 3};
    private static final String IDLE = "WAIT";
    private static final int LIMIT_MS = 60_000;
    /** Levels beyond the folders of a project that are tried: a contest's last league often has none. */
    private static final int MORE_LEVELS = 2;
    private static final DefaultIndenter LINES = new DefaultIndenter("  ", "\n");
    private static final DefaultPrettyPrinter INDENTED = new DefaultPrettyPrinter(
        Separators.createDefaultInstance().withObjectNameValueSpacing(Spacing.AFTER)).withObjectIndenter(LINES)
        .withArrayIndenter(LINES);

    private final SdkProject project;
    private final Supplier<Isolation> isolation;
    private final Consumer<String> told;
    private final Set<Name> undetermined = EnumSet.noneOf(Name.class);
    /** Games with fresh classes by the levels that differ. */
    private final Map<Integer, List<Map<Name, Long>>> fresh = new TreeMap<>();
    private int players;
    private int level;
    private boolean reuse;

    private Adoption(SdkProject project, Supplier<Isolation> isolation, Consumer<String> told) {
        this.project = project;
        this.isolation = isolation;
        this.told = told;
    }

    /**
     * Adopts a project.
     *
     * @param path   its folder or jar
     * @param engine version of the SDK to build with, or {@code null} for its own
     * @param told   is told what is done and found, a line at a time
     * @return the scene as JSON
     * @throws steward.files.InputException if it cannot be built
     * @throws RefereeFault                 if no trial game comes to its end
     */
    public static String scene(Path path, String engine, String name, Supplier<Isolation> isolation,
                               Consumer<String> told) {
        Adoption adoption = new Adoption(SdkProject.find(path, engine, told), isolation, told);
        try {
            adoption.findPlayers();
            adoption.findLevels();
            adoption.findDifferences();
        } finally {
            ResidentReferees.shared().close();
        }
        return adoption.json(name);
    }

    private void findPlayers() {
        List<Integer> numbers = new ArrayList<>();
        RefereeFault fault = null;
        for (int number = project.fewestPlayers(); number <= project.mostPlayers(); number++) {
            try {
                play(program(project.levels(), null), number, 1);
                numbers.add(number);
            } catch (RefereeFault problem) {
                fault = problem;
            }
        }
        if (numbers.isEmpty()) {
            throw fault;
        }
        players = numbers.get(0);
        told.accept("players: " + numbers + ", " + project.mode() + "; the scene has " + players);
    }

    /** Groups the levels by their games. There may be more than folders; the highest that differs is taken. */
    private void findLevels() {
        List<String> rules = new ArrayList<>();
        List<List<Map<Name, Long>>> games = new ArrayList<>();
        for (int next = 1; next <= project.levels() + MORE_LEVELS; next++) {
            List<Map<Name, Long>> played = series(program(next, null));
            int same = games.indexOf(played);
            games.add(played);
            if (same < 0) {
                level = next;
                fresh.put(next, played);
            }
            if (same < 0 || next <= project.levels()) {
                rules.add(next + (same < 0 ? "" : " (as " + (same + 1) + ")"));
            }
        }
        told.accept("league levels: " + String.join(", ", rules) + "; the scene has " + level);
    }

    private void findDifferences() {
        List<Map<Name, Long>> first = fresh.get(level);
        ResidentReferees.shared().close();
        List<Map<Name, Long>> second = series(program(level, null));
        ResidentReferees.shared().close();
        Set<Name> differing = differences(first, second);
        String fixed = differing.stream().filter(name -> !GuestProgram.FOR_PEOPLE.contains(name)).map(Name::name)
            .collect(Collectors.joining(", "));
        undetermined.addAll(differing);
        undetermined.retainAll(GuestProgram.FOR_PEOPLE);
        told.accept(!fixed.isEmpty() ? "not deterministic: " + fixed + " differ when a game is played again with its "
            + "seed, so that no replay can be verified" : undetermined.isEmpty()
            ? "deterministic: games played again were the same in every line"
            : "deterministic but for " + names(undetermined) + ", which are not recorded");
        series(program(level, "one level"));                // what it leaves in static fields shows in the next
        Set<Name> kept = differences(first, series(program(level, "one level")));
        kept.removeAll(undetermined);
        reuse = kept.isEmpty() && fixed.isEmpty();
        Set<Name> mixed = reuse ? mixed() : Set.of();
        told.accept("classes kept from game to game: " + (!reuse ? names(kept) + " differ, so each game gets fresh ones"
            : "the same games, so the scene reuses them" + (mixed.isEmpty() ? "" : "; one JVM one level, since "
                + names(mixed) + " differ where levels are mixed")));
    }

    /** Blocks that differ where one JVM with kept classes plays all levels in turn. */
    private Set<Name> mixed() {
        Set<Name> mixed = new TreeSet<>();
        for (int game = 0; game < SEEDS.length; game++) {
            for (int each : fresh.keySet()) {
                mixed.addAll(differences(List.of(fresh.get(each).get(game)),
                    List.of(play(program(each, "all levels"), players, SEEDS[game]))));
            }
        }
        mixed.removeAll(undetermined);
        return mixed;
    }

    private static String names(Set<Name> names) {
        return names.stream().map(Name::name).collect(Collectors.joining(", "));
    }

    private static Set<Name> differences(List<Map<Name, Long>> first, List<Map<Name, Long>> second) {
        Set<Name> found = new TreeSet<>();
        for (int game = 0; game < first.size(); game++) {
            for (Name name : Name.values()) {
                if (!first.get(game).getOrDefault(name, 0L).equals(second.get(game).getOrDefault(name, 0L))) {
                    found.add(name);
                }
            }
        }
        return found;
    }

    private GuestProgram program(int ofLevel, String kept) {
        Map<String, String> system = Map.of("game.mode", project.mode(), GuestProgram.LEVEL,
            Integer.toString(ofLevel));
        return new GuestProgram(List.of(), project.classPath(), GuestProgram.SDK_MAIN, kept, system, project.testIn(),
            Map.of(), LIMIT_MS, Set.of());
    }

    private List<Map<Name, Long>> series(GuestProgram program) {
        List<Map<Name, Long>> games = new ArrayList<>();
        for (long seed : SEEDS) {
            games.add(play(program, players, seed));
        }
        return games;
    }

    /** Plays a game and returns a hash of all that was said in each kind of block. */
    private Map<Name, Long> play(GuestProgram program, int number, long seed) {
        GuestGame game = new GuestGame(program, number, seed, isolation, null);
        Map<Name, Long> said = new EnumMap<>(Name.class);
        try {
            game.blocks().forEach(block -> add(said, block));
            while (!game.isOver()) {
                game.answer(new ArrayList<>(List.of(IDLE.concat("\n").repeat(game.lines()).split("\n"))), 1);
                game.play();
                game.blocks().forEach(block -> add(said, block));
            }
            return said;
        } finally {
            game.close();
        }
    }

    private static void add(Map<Name, Long> said, Block block) {
        said.merge(block.name(), block.lines().hashCode() + 1L, (before, more) -> before * 31 + more);
    }

    private String json(String name) {
        Map<String, Object> referee = new LinkedHashMap<>();
        referee.put("mode", project.mode());
        referee.put("leagueLevel", level);
        referee.put(GuestProgram.LEVELS, Math.max(level, project.levels()));
        if (reuse) {
            referee.put("reuse", "classes");
        }
        if (!undetermined.isEmpty()) {
            referee.put("undetermined", undetermined);
        }
        if (!project.testIn().isEmpty()) {
            referee.put("testIn", project.testIn());
        }
        referee.put("classPath", project.classPath());
        Map<String, Object> scene = new LinkedHashMap<>(Map.of("name", name));
        scene.put("game", GuestType.ID);
        scene.put("players", players);
        scene.put("referee", referee);
        return JsonMapper.shared().writer().with(INDENTED).writeValueAsString(scene) + "\n";
    }
}
