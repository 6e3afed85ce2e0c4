package steward.cli.tournament;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.stream.Stream;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import steward.cli.check.BotCheck;
import steward.cli.league.run.NoServing;
import steward.cli.league.run.RunCommand;
import steward.cli.league.view.GameFailures;
import steward.cli.league.view.LeagueOpening;
import steward.cli.league.view.OwnValues;
import steward.cli.league.view.PageCommand;
import steward.cli.league.view.TableCommand;
import steward.cli.options.ProgramCommand;
import steward.cli.options.ProtocolWord;
import steward.cli.options.ShippedScenes;
import steward.cli.options.ThreadsOption;
import steward.cli.options.TimeLimitOptions;
import steward.cli.shared.FailedException;
import steward.cli.shared.Games;
import steward.cli.streams.Json;
import steward.cli.streams.Streams;
import steward.contest.Contest;
import steward.contest.Hiccups;
import steward.contest.KeptReplays;
import steward.files.InputException;
import steward.files.OutputFiles;
import steward.json.JsonObject;
import steward.league.LeagueBot;
import steward.league.LeagueFolder;
import steward.league.LeagueSettings;
import steward.league.StoredGame;
import steward.league.page.LeagueJson;
import steward.match.Protocol;
import steward.scene.SceneFiles;
import steward.text.TextFormat;

/** {@code steward tournament}: everybody in a folder against everybody. */
@Command(name = "tournament", description = "Compiles and checks the programs of a folder, lets everybody meet "
    + "everybody, and writes a table and a page for each author.",
    footer = {"",
        "A program is one source file of Python, Java, C++ or JavaScript, or a folder",
        "whose file 'run' holds its command, such as 'python3 main.py'. Compilers run in",
        "the sandbox, for --compile-limit seconds at most. A program that fails stops",
        "nobody; the page of its author says why it failed and what it was sent.",
        "",
        "The folder of --page has index.html, a page for each author in bots/, the table",
        "as table.csv, and in league/ a league, which 'steward league' goes on with. The",
        "same command plays what is new: changed programs, and more --games.",
        "", "--json: folder, programs (name, ready, standing), and the table as in 'league",
        "table --json'.",
        "", "Examples:",
        "  steward tournament submissions --scene mad-pod-racing",
        "  steward tournament submissions --games 10 --page results --threads auto",
        "", "Exit status: 0 done, whatever programs do; 1 it could not be brought to its end;",
        "2 the call or the folder is unusable; 130 interrupted, the same command goes on."})
public final class TournamentCommand extends ProgramCommand {

    static final String PAGES = "bots";
    private static final String INDEX = "index.html";
    private static final List<String> LEVELS = List.of("auto", "strict", "light", "off");
    private static final int MOST_GAMES = 100_000;

    @Parameters(index = "0", paramLabel = "FOLDER", description = "The folder with the programs.")
    private String folder;

    @Option(names = "--scene", paramLabel = "FILE|NAME", defaultValue = "mad-pod-racing",
        completionCandidates = ShippedScenes.class, description = "The scene: a file, or one of "
            + "${COMPLETION-CANDIDATES} (default: ${DEFAULT-VALUE}).")
    private String scene;

    @Option(names = "--games", paramLabel = "N", defaultValue = "4", description = "Games of every group that can "
        + "meet, rounded up to whole seeds from all seats (default: ${DEFAULT-VALUE}).")
    private Integer games;

    @Option(names = "--page", paramLabel = "DIR", description = "The folder of what is written (default: FOLDER with "
        + "-tournament behind its name).")
    private String page;

    @Option(names = "--protocol", paramLabel = "P", defaultValue = "codingame",
        completionCandidates = ProtocolWord.Candidates.class,
        description = "What programs speak: json or codingame (default: ${DEFAULT-VALUE}).")
    private String protocol;

    @Option(names = "--compile-limit", paramLabel = "S", defaultValue = "60",
        description = "Seconds for the compilation of one program (default: ${DEFAULT-VALUE}).")
    private Integer compileLimit;

    @Option(names = "--sandbox", paramLabel = "LEVEL", defaultValue = "auto",
        description = "How far programs are kept apart: strict, light, off or auto, as in 'match' "
            + "(default: ${DEFAULT-VALUE}).")
    private String sandbox;

    @Option(names = "--json", description = "Prints one JSON object when all is over, and no table; see below.")
    private boolean json;

    @Mixin
    private final TimeLimitOptions pace = new TimeLimitOptions();

    @Mixin
    private final ThreadsOption threads = new ThreadsOption();

    /**
     * A program of the tournament.
     *
     * @param check what its check found, or {@code null} if it cannot run
     */
    record Entry(Workshop.Ready ready, BotCheck check) {

        String name() {
            return ready.program().name();
        }

        String standing() {
            return ready.problem() != null ? "cannot run: " + ready.problem().lines().findFirst().orElse("")
                : check.passes() ? "is ready" : check.problems().get(0);
        }
    }

    @Override
    public Integer call() throws Exception {
        check.range("--games", games, 1, MOST_GAMES);
        check.range("--compile-limit", compileLimit, 1, (int) TimeUnit.HOURS.toSeconds(1));
        check.that(LEVELS.contains(sandbox), "--sandbox: found '" + sandbox + "', expected auto, strict, light or off");
        threads.check();
        Path from = OutputFiles.path(folder);
        Path into = page == null ? from.resolveSibling(from.toAbsolutePath().normalize().getFileName() + "-tournament")
            : OutputFiles.path(page);
        Protocol spoken = ProtocolWord.parse(protocol);
        Programs programs = Programs.in(from, into);
        Games.open(scene);
        LeagueFolder league = new LeagueFolder(into.resolve("league"));
        boolean before = Files.isRegularFile(league.settings());
        prepare(into, before);
        LeagueSettings settings = settings(league, before, spoken);
        Contest empty = LeagueOpening.contest(league, settings, streams);
        Contest.checkPlayable(empty.setup(), List.of(new Contest.Entrant("all", "all", spoken, List.of())));
        programs.others().forEach(other -> streams.err().println("steward: " + TextFormat.plain(other)
            + " is no program, and is passed over"));
        List<Entry> entries = entries(programs, into, empty, spoken);
        List<LeagueBot> bots = entries.stream().filter(entry -> entry.check() != null).map(entry -> bot(entry, spoken))
            .toList();
        if (bots.size() < Math.max(1, empty.players())) {
            new IndexPage(entries, null, "Too few programs can run.").write(into.resolve(INDEX));
            throw new FailedException("found " + TextFormat.count(bots.size(), "program") + " that can run, expected "
                + "at least " + empty.players() + "; see " + into.resolve(INDEX));
        }
        league.write(settings.withBots(with(settings.bots(), bots)));
        new IndexPage(entries, null, "The games are not over yet: the table comes when they are. If they were "
            + "interrupted, the same command goes on.").write(into.resolve(INDEX));
        long total = total(league, bots, empty.players());
        streams.err().println("Everybody meets everybody: " + TextFormat.count(total, "game") + " in all");
        int status = new RunCommand(new NoServing()).run(json ? streams.withoutOutput() : streams,
            league.path().toString(), "--games", "" + total, "--pause-after", "0", "--threads",
            "" + threads.count(streams));
        finish(league, into, entries);
        return status;
    }

    private static void prepare(Path into, boolean before) {
        OutputFiles.prepareFolder(into);
        try (Stream<Path> files = Files.list(into)) {
            if (!before && files.findAny().isPresent()) {
                throw new InputException(into + ": found a folder with files, expected a new one or that of an earlier "
                    + "tournament");
            }
            Files.createDirectories(into.resolve(PAGES));
            for (String each : List.of("programs", "league")) {
                OutputFiles.privateFolder(into.resolve(each));
            }
        } catch (IOException problem) {
            throw new InputException(into + ": cannot be written: " + OutputFiles.reason(into, problem));
        }
    }

    private LeagueSettings settings(LeagueFolder league, boolean before, Protocol spoken) throws IOException {
        LeagueSettings known = before ? league.read() : LeagueSettings.usual(scene, 1);
        boolean file = SceneFiles.file(scene).isPresent();
        if (file) {
            SceneFiles.copy(Path.of(scene), league.path().resolve(LeagueFolder.SCENE));
        }
        String named = file ? LeagueFolder.SCENE : SceneFiles.shipped().contains(scene) ? scene
            : scene.replaceFirst("\\.json$", "");
        LeagueSettings settings = new LeagueSettings(named, known.seed(), null, false, known.lag(), pace.factor(),
            pace.basis(), Hiccups.REPLAY, List.of("--sandbox", sandbox), KeptReplays.FAILED, List.of(), known.bots());
        league.write(settings);
        return settings;
    }

    /** Makes ready and checks each program, alone, and writes the pages of the authors. */
    private List<Entry> entries(Programs programs, Path into, Contest empty, Protocol spoken)
            throws IOException, InterruptedException {
        Workshop workshop = new Workshop(into.resolve("programs").toAbsolutePath().normalize(), empty.isolation().get(),
            TimeUnit.SECONDS.toMillis(compileLimit));
        List<Entry> entries = new ArrayList<>();
        for (Programs.Program program : programs.programs()) {
            Workshop.Ready ready = workshop.make(program);
            Entry entry = new Entry(ready, ready.problem() != null ? null : BotCheck.of(empty,
                Contest.entrant(bot(ready, spoken).typed(), spoken)));
            entries.add(entry);
            new AuthorPage(entry, List.of()).write(page(into, entry));
            streams.err().println(TextFormat.plain(entry.name() + ": " + entry.standing()));
        }
        return entries;
    }

    private static Path page(Path into, Entry entry) {
        return into.resolve(PAGES).resolve(entry.name() + ".html");
    }

    private static LeagueBot bot(Entry entry, Protocol spoken) {
        return bot(entry.ready(), spoken);
    }

    private static LeagueBot bot(Workshop.Ready ready, Protocol spoken) {
        String prefix = spoken == Protocol.CODINGAME ? "codingame:" : "json:";
        return new LeagueBot(ready.program().name(), prefix + steward.bot.command.CommandLine.quote(ready.command()),
            ready.files().stream().map(Path::toString).toList(), false, false);
    }

    /** The bots of the league: those that are gone play no more. */
    private static List<LeagueBot> with(List<LeagueBot> known, List<LeagueBot> now) {
        List<LeagueBot> all = new ArrayList<>();
        for (LeagueBot bot : known) {
            if (now.stream().noneMatch(each -> each.name().equals(bot.name()))) {
                all.add(bot.retired(true));
            }
        }
        all.addAll(now);
        return all;
    }

    /** Number of games that the league has when every group has met so often. */
    private long total(LeagueFolder league, List<LeagueBot> bots, int players) {
        Map<List<String>, Integer> met = new HashMap<>();
        long[] played = {0};
        if (Files.exists(league.database())) {
            try (LeagueOpening.Opened opened = LeagueOpening.read(league)) {
                Map<Integer, String> names = new HashMap<>();
                opened.entries().stream().filter(entry -> entry.active()).forEach(entry -> names.put(entry.version(),
                    entry.name().replaceFirst("#.*", "")));
                opened.games().games(game -> {
                    played[0] += game.decision() >= 0 && (game.counts() || game.problem() != null) ? 1 : 0;
                    if (game.counts()) {
                        met.merge(game.seats().stream().map(seat -> names.getOrDefault(seat.version(), "")).sorted()
                            .toList(), 1, Integer::sum);
                    }
                });
            } catch (InputException withoutGames) {
                met.clear();
            }
        }
        int wanted = (games + players - 1) / players * players;
        long[] missing = {0};
        groups(bots.stream().map(LeagueBot::name).sorted().toList(), players, 0, new ArrayList<>(), group ->
            missing[0] += Math.max(0, wanted - met.getOrDefault(group, 0)));
        return Math.max(1, played[0] + missing[0]);
    }

    private static void groups(List<String> names, int size, int from, List<String> group,
                               Consumer<List<String>> taker) {
        if (group.size() == size) {
            taker.accept(List.copyOf(group));
            return;
        }
        for (int k = from; k < names.size(); k++) {
            group.add(names.get(k));
            groups(names, size, k + 1, group, taker);
            group.remove(group.size() - 1);
        }
    }

    /** The table, the pages of authors with their games, and the page of the league. */
    private void finish(LeagueFolder league, Path into, List<Entry> entries) throws Exception {
        try (LeagueOpening.Opened opened = LeagueOpening.read(league)) {
            OwnValues own = new OwnValues();
            opened.games().games(own::add);
            Files.writeString(into.resolve("table.csv"), TableCommand.csv(opened.table(), own));
            new IndexPage(entries, opened.table(), null).write(into.resolve(INDEX));
            if (json) {
                Json.print(streams, out -> {
                    out.writeStringProperty("folder", into.toString());
                    JsonObject.writeAll(out, "programs", entries, entry -> {
                        out.writeStringProperty("name", entry.name());
                        out.writeBooleanProperty("ready", entry.check() != null && entry.check().passes());
                        out.writeStringProperty("standing", entry.standing());
                    });
                    LeagueJson.table(out, opened.season(), opened.table(), opened.workers());
                });
            }
            Map<Integer, String> names = new HashMap<>();
            opened.entries().forEach(entry -> names.put(entry.version(), entry.name()));
            for (Entry entry : entries) {
                GameFailures failures = new GameFailures();
                int[] count = {0};
                opened.entries().stream().filter(each -> each.active() && names.get(each.version())
                    .replaceFirst("#.*", "").equals(entry.name())).forEach(each ->
                    opened.games().gamesOf(each.version(), game -> {
                        count[0] += game.counts() ? 1 : 0;
                        failures.add(of(game, each.version()));
                    }));
                List<String> lines = new ArrayList<>(List.of(TextFormat.count(count[0], "game")));
                lines.addAll(failures.lines(names));
                new AuthorPage(entry, lines).write(page(into, entry));
            }
        }
        Streams told = json ? streams.withoutOutput() : streams;
        new PageCommand().run(told, league.path().toString(), "--out", into.resolve("league.html").toString());
        told.out().println("Written: " + into.resolve(INDEX) + ", " + into.resolve("table.csv")
            + ", and a page for each author in " + into.resolve(PAGES));
    }

    /** The game with the failures of one version alone. */
    private static StoredGame of(StoredGame game, int version) {
        return new StoredGame(game.id(), game.name(), game.decision(), game.seed(), game.attempt(), game.counts(),
            game.turns(), game.problem(), game.played(), game.machine(), game.replay(), game.transcript(),
            game.seats().stream().filter(seat -> seat.version() == version).toList());
    }
}
