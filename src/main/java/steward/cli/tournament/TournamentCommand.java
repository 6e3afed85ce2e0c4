package steward.cli.tournament;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import steward.bot.command.CommandLine;
import steward.bot.isolation.SandboxLevel;
import steward.bot.isolation.SandboxSupport;
import steward.cli.check.BotCheck;
import steward.cli.league.view.LeagueOpening;
import steward.cli.league.view.PageCommand;
import steward.cli.options.ProgramCommand;
import steward.cli.options.SeedFileOption;
import steward.cli.options.ShippedScenes;
import steward.cli.options.ThreadsOption;
import steward.cli.options.TimeLimitOptions;
import steward.cli.options.WatchOptions;
import steward.cli.shared.FailedException;
import steward.cli.shared.Games;
import steward.cli.shared.Pages;
import steward.cli.streams.Json;
import steward.contest.Contest;
import steward.contest.Hiccups;
import steward.contest.KeptReplays;
import steward.contest.seeds.SeedFile;
import steward.files.InputException;
import steward.files.OutputFiles;
import steward.league.FolderLock;
import steward.league.LeagueBot;
import steward.league.LeagueFolder;
import steward.league.LeagueSettings;
import steward.league.StoredGame;
import steward.league.page.EmbeddedReplays;
import steward.league.page.LeagueJson;
import steward.league.page.LeaguePage;
import steward.league.page.LeagueView;
import steward.league.play.Roster;
import steward.league.rating.LeagueTable;
import steward.match.OwnLimits;
import steward.match.Protocol;
import steward.report.Fields;
import steward.scene.Scene;
import steward.scene.SceneFiles;
import steward.text.TextFormat;

/**
 * {@code steward tournament}: plays all programs in a folder against each other. Over 400 lines, because a quarter of
 * them are options and help.
 */
@Command(name = "tournament", description = "Compiles and checks the programs of a folder, plays all of them "
    + "against each other, and writes a table and a page for each author.",
    footer = {
        "", "A program is one source file of Python, Java, C++ or JavaScript, or a folder",
        "whose file 'run' holds its command, such as 'python3 main.py'. Compilers run in",
        "the sandbox, for --compile-limit seconds at most. If a program fails, the",
        "others play on; its author's page says why it failed and what it was sent.",
        "", "The folder of --page has index.html, a page for each author in bots/, and the",
        "table as table.csv. Its folder league/ is a league for 'steward league'. The",
        "same command plays only what is new: changed programs, and more --games. Table",
        "and pages show the programs as they are now, all with equally many games.",
        "Links, pipes and devices among hand-ins are not opened. A round of --rounds is",
        "written to rounds.json before its games; new versions begin at the first round.",
        "", "--json: folder, programs (name, ready, standing), scores (place, name, games,",
        "won, drawn, lost, failed, points, tie), and the ratings as in 'league table",
        "--json'.",
        "", "Examples:",
        "  steward tournament submissions --scene mad-pod-racing",
        "  steward tournament submissions --games 10 --page results --threads auto",
        "  steward tournament submissions --rounds 5 --watch --host 0.0.0.0",
        "", "Exit status: 0 done, whatever programs do; 1 it could not be finished; 2 the",
        "call or the folder is unusable; 130 interrupted: the same command continues."})
public final class TournamentCommand extends ProgramCommand {

    static final String PAGES = "bots";
    private static final String INDEX = "index.html";
    private static final List<String> LEVELS = List.of("auto", "strict", "light", "off");
    private static final int MOST_GAMES = 100_000;
    private static final int MOST_ROUNDS = 100;
    private static final int MOST_MEGABYTES = 100_000;
    private static final int MOST_FILES = 1_000_000;
    /** Up to so many games of a group all replays are kept; of more only those of failures, as they fill the disk. */
    private static final int ALL_KEPT = 20;

    @Parameters(index = "0", paramLabel = "FOLDER", description = "The folder with the programs.")
    private String folder;

    @Option(names = "--scene", paramLabel = "FILE|NAME", defaultValue = "mad-pod-racing",
        completionCandidates = ShippedScenes.class, description = "The scene: a file, or one of "
            + "${COMPLETION-CANDIDATES} (default: ${DEFAULT-VALUE}).")
    private String scene;

    @Option(names = "--games", paramLabel = "N", defaultValue = "4", description = "Games of every group that can "
        + "meet, rounded up to whole seeds from all seats (default: ${DEFAULT-VALUE}).")
    private Integer games;

    @Option(names = "--rounds", paramLabel = "R", description = "Plays R Swiss rounds, in which programs with "
        + "equal points meet, --games times. Without it everybody meets everybody.")
    private Integer rounds;

    @Option(names = "--page", paramLabel = "DIR", description = "The folder for the results (default: FOLDER with "
        + "-tournament behind its name).")
    private String page;

    @Option(names = "--protocol", paramLabel = "P", defaultValue = "codingame",
        description = "The protocol of the programs: json or codingame (default: ${DEFAULT-VALUE}).")
    private Protocol protocol;

    @Option(names = "--compile-limit", paramLabel = "S", defaultValue = "60",
        description = "Seconds for the compilation of one program (default: ${DEFAULT-VALUE}).")
    private Integer compileLimit;

    @Option(names = "--cxx-flags", paramLabel = "WORDS", defaultValue = "", description = "Gives these words to "
        + "the C++ compiler, after -O2 and -std=c++20 (or the newest standard that it has).")
    private String cxxFlags;

    @Option(names = "--most-megabytes", paramLabel = "N", defaultValue = "50",
        description = "A program with more megabytes is refused (default: ${DEFAULT-VALUE}).")
    private Integer mostMegabytes;

    @Option(names = "--most-files", paramLabel = "N", defaultValue = "2000",
        description = "A program of more files and folders is refused (default: ${DEFAULT-VALUE}).")
    private Integer mostFiles;

    @Option(names = "--sandbox", paramLabel = "LEVEL",
        description = "How programs are isolated: strict, light, off or auto, as in 'match' (default: strict if "
            + "that works, otherwise auto).")
    private String sandbox;

    @Option(names = "--json", description = "Prints one JSON object when all is over, and no table; see below.")
    private boolean json;

    @Mixin
    private final TimeLimitOptions pace = new TimeLimitOptions();

    @Mixin
    private final SeedFileOption list = new SeedFileOption();

    @Mixin
    private final ThreadsOption threads = new ThreadsOption();

    @Mixin
    private final WatchOptions watch = new WatchOptions();

    /** By the names of programs that have their own. */
    private Map<String, OwnLimits> limits;
    /** Flags the table if games of programs chose the seeds; {@code null} otherwise. */
    private String flag;

    /**
     * A program of the tournament.
     *
     * @param check what its check found, or {@code null} if it cannot run
     */
    record Entry(Workshop.Ready ready, BotCheck check) {

        String name() {
            return ready.program().name();
        }

        boolean isReady() {
            return ready.problem() == null && check.passes();
        }

        /** Its first problem, for its author and who called. */
        String standing() {
            return ready.problem() != null ? "cannot run: " + ready.problem().lines().findFirst().orElse("")
                : check.passes() ? "is ready" : check.problems().get(0);
        }

        /** The same without a word of its source, its stderr and its answers. */
        String standingForAll() {
            return ready.problem() != null ? "cannot run" + (ready.problem().startsWith(Workshop.COMPILER)
                    ? ": " + Workshop.COMPILER : "")
                : check.passes() ? "is ready" : check.failure() == null ? check.problems().get(0)
                : "failed in turn " + check.failure().turn() + ": " + check.failure().kind();
        }
    }

    @Override
    @SuppressWarnings("try")                           // the lock is only closed, never used
    public Integer call() throws Exception {
        check.range("--games", games, 1, MOST_GAMES);
        check.range("--compile-limit", compileLimit, 1, (int) TimeUnit.HOURS.toSeconds(1));
        sandbox = sandbox != null ? sandbox : SandboxSupport.problem(SandboxLevel.STRICT) == null ? "strict" : "auto";
        check.that(LEVELS.contains(sandbox), "--sandbox: found '" + sandbox + "', expected auto, strict, light or off");
        check.range("--most-megabytes", mostMegabytes, 1, MOST_MEGABYTES);
        check.range("--most-files", mostFiles, 1, MOST_FILES);
        check.range("--rounds", rounds, 1, MOST_ROUNDS);
        threads.check();
        list.check(false, true);
        watch.check(check);
        Path from = OutputFiles.path(folder);
        Path into = page == null ? from.resolveSibling(from.toAbsolutePath().normalize().getFileName() + "-tournament")
            : OutputFiles.path(page);
        Programs programs = Programs.in(from, into);
        limits = pace.own(programs.programs().stream().map(Programs.Program::name).toList());
        Scene opened = Games.open(scene).scene();
        if (rounds != null && opened.players() < 2) {
            throw new InputException("--rounds: found " + opened.name() + ", which each plays alone, expected a scene "
                + "for several players");
        }
        int seats = Math.max(1, opened.players());
        if (list.isGiven()) {
            list.atLeast((long) (games + seats - 1) / seats * (rounds == null ? 1 : rounds), ", one for each game of "
                + "a group from the same seats");
        }
        flags();                                       // refused before anything is written
        LeagueFolder league = new LeagueFolder(into.resolve("league"));
        boolean before = Files.isRegularFile(league.settings());
        prepare(into, before);
        try (FolderLock lock = FolderLock.take(new LeagueFolder(into));
             ProjectorWall wall = watch.watch() ? ProjectorWall.start(watch, streams) : null) {
            return call(from, into, programs, league, settings(league, before), wall);
        }
    }

    private int call(Path from, Path into, Programs programs, LeagueFolder league, LeagueSettings settings,
                     ProjectorWall wall) throws Exception {
        Contest empty = LeagueOpening.contest(league, settings, streams);
        Contest.checkPlayable(empty.setup(), List.of(new Contest.Entrant("all", "all", protocol, List.of())));
        programs.others().forEach(other -> streams.err().println("steward: " + TextFormat.plain(other)
            + " is no program, and is passed over"));
        List<Entry> entries = entries(programs, into, empty);
        List<LeagueBot> bots = entries.stream().filter(entry -> entry.check() != null).map(entry -> bot(entry.ready()))
            .toList();
        if (bots.size() < Math.max(1, empty.players())) {
            new IndexPage(entries, null, List.of("Too few programs can run.")).write(into.resolve(INDEX));
            throw new FailedException("found " + TextFormat.count(bots.size(), "program") + " that can run, expected "
                + "at least " + empty.players() + "; see " + into.resolve(INDEX));
        }
        SeedFile seeds = list.isGiven() ? list.read() : league.seeds(settings);
        List<String> choosers = list.choosers(seeds, bots.stream().map(LeagueBot::entrant).toList());
        league.write(adopting(league, settings).withBots(bots));
        new IndexPage(entries, null, List.of("The games are not over yet: the table comes when they are. If they were "
            + "interrupted, the same command goes on.")).write(into.resolve(INDEX));
        Roster roster = TournamentRun.roster(league, league.read(), empty, streams);
        int seats = Math.max(1, empty.players());
        TournamentRun run = new TournamentRun(league, roster, seats, (games + seats - 1) / seats,
            json ? streams.withoutOutput() : streams, threads.count(streams), wall);
        if (rounds != null && !empty.hold().isEmpty()) {
            streams.err().println("steward: " + TextFormat.plain(empty.hold()));
        }
        int status = rounds == null ? run.playAll() : run.playRounds(rounds, into);
        flag = SeedFileOption.flag(choosers);
        finish(league, into, entries, run);
        if (wall != null) {
            wall.end(run.played());
        }
        changes(from, into, entries);
        return status;
    }

    /** Says what was handed in during the games. */
    private void changes(Path from, Path into, List<Entry> entries) {
        List<String> lines = new ArrayList<>();
        Map<Path, Workshop.Ready> known = new HashMap<>();
        entries.forEach(entry -> known.put(entry.ready().program().source(), entry.ready()));
        try {
            for (Programs.Program program : Programs.in(from, into).programs()) {
                Workshop.Ready ready = known.remove(program.source());
                if (ready == null || ready.isChanged(bounds())) {
                    lines.add(program.source().getFileName() + (ready == null ? " has come" : " has changed"));
                }
            }
        } catch (InputException allGone) {
            lines.clear();
        }
        known.keySet().stream().sorted().forEach(gone -> lines.add(gone.getFileName() + " has gone"));
        lines.forEach(line -> streams.err().println("steward: " + TextFormat.plain(line)
            + " since the programs were copied; the next call sees it"));
    }

    private HandIn.Bounds bounds() {
        return new HandIn.Bounds(mostMegabytes, mostFiles);
    }

    private static void prepare(Path into, boolean before) {
        OutputFiles.prepareFolder(into);
        try (Stream<Path> files = Files.list(into)) {
            if (!before && files.findAny().isPresent()) {
                throw new InputException(into + ": found a folder with files, expected a new one or that of an earlier "
                    + "tournament");
            }
            Files.createDirectories(into.resolve(PAGES));
            for (String each : List.of(Programs.FOLDER, "league")) {
                OutputFiles.privateFolder(into.resolve(each));
            }
        } catch (IOException problem) {
            throw new InputException(into + ": cannot be written: " + OutputFiles.reason(into, problem));
        }
    }

    private LeagueSettings settings(LeagueFolder league, boolean before) throws IOException {
        LeagueSettings known = before ? league.read() : LeagueSettings.usual(scene, 1);
        boolean file = SceneFiles.file(scene).isPresent();
        if (file) {
            SceneFiles.copy(Path.of(scene), league.path().resolve(LeagueFolder.SCENE));
        }
        String named = file ? LeagueFolder.SCENE : SceneFiles.shipped().contains(scene) ? scene
            : scene.replaceFirst("\\.json$", "");
        LeagueSettings settings = new LeagueSettings(named, known.seed(), known.seedFile(), null, false, known.lag(),
            pace.factor(), pace.basis(), Hiccups.REPLAY, List.of("--sandbox", sandbox), games > ALL_KEPT
                ? KeptReplays.FAILED : KeptReplays.ALL, List.of(), known.bots());
        league.write(settings);
        return settings;
    }

    /** Takes the list of the call, if there is one, into the league: not before it is known that it may be played. */
    private LeagueSettings adopting(LeagueFolder league, LeagueSettings settings) throws IOException {
        if (!list.isGiven()) {
            return settings;
        }
        OutputFiles.replace(league.path().resolve(LeagueFolder.SEEDS),
            list.read().text().getBytes(StandardCharsets.UTF_8));
        return settings.listing(LeagueFolder.SEEDS);
    }

    private List<String> flags() {
        return cxxFlags.isBlank() ? List.of()
            : InputException.of("--cxx-flags: ", () -> CommandLine.split(cxxFlags));
    }

    /** Makes ready and checks each program, alone, and writes the pages of the authors. */
    private List<Entry> entries(Programs programs, Path into, Contest empty)
            throws IOException, InterruptedException {
        Workshop workshop = new Workshop(into.resolve(Programs.FOLDER).toAbsolutePath().normalize(),
            empty.staging().isolation().get(), TimeUnit.SECONDS.toMillis(compileLimit), bounds(), flags());
        withoutPages(into, programs);
        List<Entry> entries = new ArrayList<>();
        for (Programs.Program program : programs.programs()) {
            Workshop.Ready ready = workshop.make(program);
            Entry entry = new Entry(ready, ready.problem() != null ? null : BotCheck.of(empty,
                bot(ready).entrant()));
            entries.add(entry);
            AuthorPage.before(entry).write(page(into, entry));
            streams.err().println(TextFormat.plain(entry.name() + ": " + entry.standing()));
        }
        return entries;
    }

    private static Path page(Path into, Entry entry) {
        return into.resolve(PAGES).resolve(entry.name() + ".html");
    }

    /** Deletes the pages of programs that are gone. */
    private static void withoutPages(Path into, Programs programs) throws IOException {
        List<String> names = programs.programs().stream().map(program -> program.name() + ".html").toList();
        try (Stream<Path> pages = Files.list(into.resolve(PAGES))) {
            for (Path each : pages.filter(page -> !names.contains(page.getFileName().toString())).toList()) {
                Files.delete(each);
            }
        }
    }

    private LeagueBot bot(Workshop.Ready ready) {
        String prefix = protocol == Protocol.CODINGAME ? "codingame:" : "json:";
        return new LeagueBot(ready.program().name(), prefix + CommandLine.quote(ready.command()),
            ready.files().stream().map(Path::toString).toList(), false, false).in(none -> ready.folder().toString())
            .within(limits.get(ready.program().name()));
    }

    /** The table, the pages of authors with their games, and the page of the league, all from the same games. */
    private void finish(LeagueFolder league, Path into, List<Entry> entries, TournamentRun run) throws IOException {
        PlayedGames played = run.played();
        Scores scores = run.scores(played);
        LeagueTable ratings = played.ratings();
        Files.writeString(into.resolve("table.csv"), scores.csv(played, ratings));
        List<String> notes = new ArrayList<>(scores.notes(played));
        if (flag != null) {
            notes.add(flag);
        }
        new IndexPage(entries, scores, notes).write(into.resolve(INDEX));
        if (json) {
            Json.print(streams, Fields.of("folder", into, "programs", Fields.each(entries, entry -> Fields.of(
                "name", entry.name(), "ready", entry.isReady(), "standing", entry.standing())),
                "scores", scores.table().json(scores.rows()))
                .and(LeagueJson.table(played.season(), ratings, List.of())).with("flag", flag));
        }
        for (Entry entry : entries) {
            AuthorPage.of(entry, played, league.replays()).write(page(into, entry));
        }
        leaguePage(played, ratings, league, into.resolve("league.html"));
        if (!json) {
            scores.table().lines(scores.rows()).forEach(streams.out()::println);
            notes.forEach(streams.out()::println);
            streams.out().println("Written: " + into.resolve(INDEX) + ", league.html, table.csv, and a page for "
                + "each author in " + PAGES);
        }
    }

    /** The page of the league over these games; nobody's stderr is in it. */
    private static void leaguePage(PlayedGames played, LeagueTable ratings, LeagueFolder league, Path file)
            throws IOException {
        int from = Math.max(0, played.games().size() - PageCommand.LISTED);
        List<StoredGame> games = new ArrayList<>(played.games().subList(from, played.games().size()));
        Collections.reverse(games);
        Map<Integer, String> names = played.names();
        OutputFiles.replace(file, LeaguePage.of(new LeagueView(played.season(), ratings, played.path(), games,
            Double.NaN, List.of()), league.replays(), EmbeddedReplays.of(games, league.replays(), Games.types(),
                (game, seat) -> false,
                game -> Pages.title(game.seats().stream().map(seat -> names.get(seat.version())).toList()))
                .beside(file, Games.types()), "Tournament"));
    }
}
