package steward.guest;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.LongStream;
import steward.bot.command.Program;
import steward.bot.isolation.Isolation;
import steward.guest.RefereeBlock.Name;
import steward.guest.project.LeagueLevels;
import steward.guest.project.SdkProject;
import steward.text.TextFormat;
import tools.jackson.core.util.DefaultIndenter;
import tools.jackson.core.util.DefaultPrettyPrinter;
import tools.jackson.core.util.Separators;
import tools.jackson.core.util.Separators.Spacing;
import tools.jackson.databind.json.JsonMapper;

/**
 * Search for the settings with which a published referee can be played as a guest. Its folders and class files tell
 * which league level has the full rules. Trial games with idle bots tell which numbers of players it allows, what is
 * equal when a game is played again, and whether its classes can be kept between games. Idle bots answer {@code WAIT}
 * and nothing else, so games between them never decide about levels.
 */
public final class Adoption {

    /** Seeds that are played, where games are short; tests are played all. */
    private static final int SEEDS = 3;
    /** Milliseconds for trial games, each of which is played up to four times. */
    private static final double BUDGET_MS = 6_000;
    private static final int LIMIT_MS = 60_000;
    private static final DefaultIndenter LINES = new DefaultIndenter("  ", "\n");
    private static final DefaultPrettyPrinter INDENTED = new DefaultPrettyPrinter(
        Separators.createDefaultInstance().withObjectNameValueSpacing(Spacing.AFTER)).withObjectIndenter(LINES)
        .withArrayIndenter(LINES);

    private final SdkProject project;
    private final Supplier<Isolation> isolation;
    private final Consumer<String> told;
    /** Blocks for people that may differ; the criterion of a game for one is no such block. */
    private final Set<Name> forPeople = EnumSet.copyOf(GuestProgram.FOR_PEOPLE);
    private final Set<Name> undetermined = EnumSet.noneOf(Name.class);
    private final Map<String, String> adopted = new LinkedHashMap<>();
    private final List<Integer> numbers = new ArrayList<>();
    private int players;
    private int level;
    private int levels;
    private boolean reuse;
    /** Questions of a trial game. */
    private int questions = GuestGame.MOST_QUESTIONS;

    private Adoption(SdkProject project, Supplier<Isolation> isolation, Consumer<String> told) {
        this.project = project;
        this.isolation = isolation;
        this.told = told;
        if (!project.criterion().isEmpty()) {
            forPeople.remove(Name.METADATA);
        }
    }

    /**
     * A scene that was made.
     *
     * @param json    of it
     * @param players of a game
     * @param boss    words of a bot that comes with the contest; empty if none can be started as it is
     */
    public record Made(String json, int players, List<String> boss) { }

    /**
     * Adopts a project.
     *
     * @param path   its folder or jar
     * @param engine version of the SDK to build with, or {@code null} for its own
     * @param source clone of the SDK's repository to build it from, or {@code null}
     * @param told   is told what is done and found, a line at a time
     * @throws steward.files.InputException if it cannot be built
     * @throws RefereeFault                 if no trial game comes to its end
     */
    public static Made scene(Path path, String engine, Path source, String name, Supplier<Isolation> isolation,
                             Consumer<String> told) {
        Adoption adoption = new Adoption(SdkProject.find(path, engine, source, told), isolation, told);
        try {
            adoption.chooseLevel();
            adoption.findDifferences();
        } finally {
            ResidentReferees.shared().close();
        }
        Program boss = adoption.project.boss();
        List<String> words = boss == null ? List.of() : List.of(Path.of(boss.words().get(0)).getFileName().toString(),
            boss.folder().resolve(boss.words().get(1)).toString());
        return new Made(adoption.json(name), adoption.players, words);
    }

    /** Chooses the level; one without a folder in which no game comes to its end is none. */
    private void chooseLevel() {
        LeagueLevels chosen = LeagueLevels.of(project);
        boolean found = false;
        if (chosen.mayHaveMore()) {
            findPlayers(chosen.level());
            found = !bossesDiffer(chosen.level());
            chosen = found ? chosen : chosen.more();
        }
        RefereeFault fault = null;
        while (!found) {
            try {
                findPlayers(chosen.level());
                found = true;
            } catch (RefereeFault problem) {
                if (chosen.level() <= Math.max(1, project.levels())) {
                    throw fault == null ? problem : fault;
                }
                fault = problem;
                chosen = chosen.withoutLast();
            }
        }
        level = chosen.level();
        levels = Math.max(level, (project.levels() == 0 ? level : project.levels()) + 1);
        adopted.put("level", chosen.reason());
        told.accept("players: " + numbers + ", " + project.mode() + "; the scene has " + players);
        told.accept("league level: " + level + ", " + chosen.reason());
    }

    private void findPlayers(int ofLevel) {
        RefereeFault fault = null;
        numbers.clear();
        for (int number = project.fewestPlayers(); number <= project.mostPlayers(); number++) {
            try {
                TrialGame.idle(program(ofLevel, null), number, 1, isolation, TrialGame.ANY);
                numbers.add(number);
            } catch (RefereeFault problem) {
                fault = problem;
            }
        }
        if (numbers.isEmpty()) {
            throw fault;
        }
        players = numbers.get(0);
    }

    /** True if a game between the contest's own bots differs at the next level, and not when it is played again. */
    private boolean bossesDiffer(int ofLevel) {
        Program boss = project.boss();
        if (boss == null) {
            return false;
        }
        try {
            TrialGame first = TrialGame.between(boss, program(ofLevel, null), players, 1, isolation, TrialGame.ANY);
            List<TrialGame> games = IntStream.of(ofLevel, ofLevel + 1).mapToObj(each -> TrialGame.between(boss,
                program(each, null), players, 1, isolation, first.questions())).toList();
            Set<Name> again = first.differences(games.get(0));
            Set<Name> differing = first.differences(games.get(1));
            again.removeAll(GuestProgram.FOR_PEOPLE);
            differing.removeAll(GuestProgram.FOR_PEOPLE);
            return again.isEmpty() && !differing.isEmpty();
        } catch (RefereeFault none) {
            return false;
        }
    }

    /** Plays games again in other JVMs, and with kept classes. */
    private void findDifferences() {
        long[] seeds = seeds();
        List<TrialGame> first = series(program(level, null), seeds);
        ResidentReferees.shared().close();
        List<TrialGame> second = series(program(level, null), seeds);
        ResidentReferees.shared().close();
        List<Integer> fixed = IntStream.range(0, seeds.length).filter(game ->
            forPeople.containsAll(first.get(game).differences(second.get(game)))).boxed().toList();
        List<TrialGame> same = pick(first, fixed.isEmpty() ? all(seeds) : fixed);
        Set<Name> differing = TrialGame.differences(same, pick(second, fixed.isEmpty() ? all(seeds) : fixed));
        Set<Name> others = new TreeSet<>(differing);
        others.removeAll(forPeople);
        undetermined.addAll(differing);
        undetermined.retainAll(forPeople);
        boolean drawn = !fixed.isEmpty() && fixed.size() < seeds.length && project.tests().size() > 1;
        if (drawn) {
            adopted.put("tests", "drawn at random: " + all(seeds).stream().filter(game -> !fixed.contains(game))
                .map(game -> Integer.toString(game + 1)).collect(Collectors.joining(", ")));
            told.accept("tests " + adopted.get("tests") + "; their replays cannot be verified, those of the other "
                + fixed.size() + " tests can");
        } else if (fixed.size() < seeds.length) {
            others.addAll(TrialGame.differences(first, second));
            others.removeAll(forPeople);
        }
        told.accept(!others.isEmpty() ? "not deterministic: " + names(others) + " differ when a game is played again "
            + "with its seed, so that no replay can be verified" : undetermined.isEmpty()
            ? "deterministic: games played again were the same in every line"
            : "deterministic but for " + names(undetermined) + ", which are not recorded");
        if (!first.stream().allMatch(TrialGame::whole)) {         // a game that is broken off ends its JVM
            told.accept("classes kept from game to game: not tried, since games take long; each game gets fresh ones");
            return;
        }
        if (!others.isEmpty() || drawn) {
            told.accept("classes kept from game to game: not tried, since games differ");
            return;
        }
        long[] few = LongStream.of(seeds).limit(SEEDS).toArray();
        series(program(level, "one level"), few);           // what it leaves in static fields shows in the next
        Set<Name> kept = TrialGame.differences(pick(first, all(few)), series(program(level, "one level"), few));
        kept.removeAll(undetermined);
        reuse = kept.isEmpty();
        told.accept("classes kept from game to game: " + (reuse ? "the same games, so the scene reuses them"
            : names(kept) + " differ, so each game gets fresh ones"));
    }

    /** Seeds to play, as many as there is time for: referees take between some milliseconds and seconds for a game. */
    private long[] seeds() {
        long began = System.nanoTime();
        TrialGame first = TrialGame.idle(program(level, null), players, 1, isolation, TrialGame.ANY);
        if (!first.whole()) {
            questions = first.questions();
            told.accept("games take long: the first " + questions + " questions of each were looked at");
        }
        double ms = (System.nanoTime() - began) / TextFormat.NANOS_PER_MS;
        int most = Math.max(SEEDS, project.tests().size());
        int count = (int) Math.max(1, Math.min(most, BUDGET_MS / (most == SEEDS ? 4 : 2) / ms));
        if (count < project.tests().size()) {
            told.accept("tried: " + count + " of " + project.tests().size() + " tests, since games take long");
        }
        return LongStream.rangeClosed(1, count).toArray();
    }

    private static List<Integer> all(long[] seeds) {
        return IntStream.range(0, seeds.length).boxed().toList();
    }

    private static List<TrialGame> pick(List<TrialGame> games, List<Integer> numbers) {
        return numbers.stream().map(games::get).toList();
    }

    private static String names(Set<Name> names) {
        return names.stream().map(Name::name).collect(Collectors.joining(", "));
    }

    private GuestProgram program(int ofLevel, String kept) {
        Map<String, String> system = Map.of("game.mode", project.mode(), GuestProgram.LEVEL,
            Integer.toString(ofLevel));
        return new GuestProgram(List.of(), project.classPath(), SdkProject.MAIN, kept, system,
            new SoloTests(project.tests(), "", false), Map.of(), LIMIT_MS, Set.of());
    }

    private List<TrialGame> series(GuestProgram program, long[] seeds) {
        return LongStream.of(seeds).mapToObj(seed -> TrialGame.idle(program, players, seed, isolation,
            questions)).toList();
    }

    private String json(String name) {
        Map<String, Object> referee = new LinkedHashMap<>();
        referee.put("mode", project.mode());
        referee.put("leagueLevel", level);
        referee.put(GuestProgram.LEVELS, levels);
        if (project.engine() != null) {
            adopted.put("engine", project.engine());
        }
        referee.put(GuestProgram.ADOPTED, adopted);
        if (reuse) {
            referee.put("reuse", "classes");
        }
        if (!undetermined.isEmpty()) {
            referee.put("undetermined", undetermined);
        }
        if (!project.criterion().isEmpty()) {
            referee.put(SoloTests.CRITERION, project.criterion());
            referee.put(SoloTests.LOWER, project.lowerIsBetter());
        }
        if (!project.tests().isEmpty()) {
            referee.put(SoloTests.FIELD, project.tests().stream().map(test -> Map.of("testIn", test)).toList());
        }
        referee.put("classPath", project.classPath());
        Map<String, Object> scene = new LinkedHashMap<>(Map.of("name", name));
        scene.put("game", GuestType.ID);
        scene.put("players", players);
        scene.put("referee", referee);
        return JsonMapper.shared().writer().with(INDENTED).writeValueAsString(scene) + "\n";
    }
}
