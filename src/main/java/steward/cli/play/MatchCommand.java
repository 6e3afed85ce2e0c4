package steward.cli.play;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Supplier;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;
import steward.bot.isolation.Isolation;
import steward.cli.options.BotFolders;
import steward.cli.options.BuiltinBotWords;
import steward.cli.options.DisplayOptions;
import steward.cli.options.OptionSection;
import steward.cli.options.ProgramCommand;
import steward.cli.options.RefereeOption;
import steward.cli.options.SandboxOptions;
import steward.cli.options.SceneOptions;
import steward.cli.options.SeedFileOption;
import steward.cli.options.SeedOption;
import steward.cli.options.TimeLimitOptions;
import steward.cli.shared.Games;
import steward.cli.shared.Verbosity;
import steward.cli.streams.StandardFiles;
import steward.contest.Contest;
import steward.contest.Series;
import steward.contest.seeds.Seeds;
import steward.files.InputException;
import steward.files.OutputFiles;
import steward.game.GameSetup;
import steward.match.Protocol;
import steward.replay.sign.SigningKey;
import steward.text.TextFormat;

/** {@code steward match}: plays one match, or a series of many. */
@Command(name = "match", description = "Plays a match between bots, or many matches.",
    footer = {
        "", "A bot is written [NAME=][builtin:|json:|codingame:]COMMAND, quoted as in a",
        "shell. Four bots come with the program, from weak to strong: 'builtin:racer',",
        "'builtin:regular', 'builtin:contender' and 'builtin:veteran'. A 'codingame:'",
        "bot speaks the site's lines of words and numbers, a 'json:' bot speaks JSON;",
        "--protocol is for all others. Give one --bot for each player of the scene, in",
        "order.",
        "", "Examples:",
        "  steward match --bot builtin:veteran --bot 'me=python3 bot.py' --seed 7 \\",
        "      --out match.jsonl",
        "  steward match --scene duel --bot ./mine --bot builtin:racer --games 50 \\",
        "      --swap --threads 2",
        "  steward match --protocol codingame --bot ./a.out --bot json:'python3 bot.py'",
        "  steward match --bot ./mine --bot builtin:racer --view match.html --open",
        "  steward match --bot ./mine --bot builtin:racer --watch --open",
        "  steward match --bot ./mine --bot builtin:racer --games 20 --swap --out games \\",
        "      --view series.html",
        "  steward match --recorded games --bot ./new --as mine",
        "", "With many games, --view writes a page with results by seed and side, answer",
        "times and failures. It holds up to 24 MB of the replays that --out keeps. The",
        "others are pages beside it. series.html#game=7&t=20 is the address of a moment.",
        "", "--watch prints the address of the page. The match begins when a browser has",
        "opened it, or when you press Enter; without a terminal, after 60 seconds. After",
        "the match, the program ends as soon as every browser has everything. Open pages",
        "stay complete, and their Save works without the program. To look again later,",
        "use --view or --out.",
        "", "Exit status: 0 there is a result; 1 there is none, or a bot failed and --strict",
        "was given; 2 wrong call; 130 interrupted (finished games of a series are",
        "reported)."})
public final class MatchCommand extends ProgramCommand {

    private static final int MOST_LEVEL = 20;
    private static final List<String> OF_OTHER_GAMES = List.of("--scene", "--accuracy", "--league-level", "--seed",
        "--seed-file", "--games", "--swap", "--out", "--sign", "--overwrite", "--keep", "--why", "--hiccups",
        "--random", "--into", "--view", "--open", "--watch");

    @Spec
    private CommandSpec spec;

    @Mixin
    private final SceneOptions scene = new SceneOptions();

    @Option(names = "--bot", paramLabel = "BOT", completionCandidates = BuiltinBotWords.class,
        description = "A bot; see below.")
    private List<String> bots = new ArrayList<>();

    @Mixin
    private final BotFolders folders = new BotFolders();

    @Option(names = "--protocol", paramLabel = "P", defaultValue = "json",
        description = "The protocol of bots without a prefix: json or codingame (default: ${DEFAULT-VALUE}).")
    private Protocol protocol;

    @Option(names = "--league-level", paramLabel = "N", description = "Plays by the rules of this league of the "
        + "site, 1 for the lowest (default: the scene's).")
    private Integer level;

    @Mixin
    private final SeedOption seed = new SeedOption();

    @Mixin
    private final SeedFileOption list = new SeedFileOption();

    @Option(names = "--out", paramLabel = "FILE",
        description = "Writes the replay to this file; - is the standard output. With --games or --swap: writes "
            + "one replay for each game into this folder.")
    private String out;

    @Option(names = "--sign", paramLabel = "KEY",
        description = "Signs the replay with this private key; see 'steward key'.")
    private String sign;

    @Option(names = "--overwrite", description = "Replaces replays and pages that exist.")
    private boolean overwrite;

    @Mixin
    private final SeriesOptions many = new SeriesOptions();

    @OptionSection("Recorded games")
    @Option(names = "--recorded", paramLabel = "DIR|REPLAY", description = "Plays recorded games again, of any scene, "
        + "with the bot in the place of one player, against the recorded answers of the others. A game goes on as long "
        + "as the others are sent what they were sent.")
    private String recorded;

    @OptionSection("Recorded games")
    @Option(names = "--as", paramLabel = "PLAYER", description = "With --recorded: in whose place the bot plays, a "
        + "name or a number counted from 0.")
    private String as;

    @Mixin
    private final RefereeOption referee = new RefereeOption();

    @Mixin
    private final DisplayOptions show = new DisplayOptions();

    @Option(names = "--quiet", description = "Prints only the line of the result.")
    private boolean quiet;

    @Option(names = "--json", description = "Prints one JSON object and nothing else.")
    private boolean json;

    @Option(names = "--strict", description = "Exits with status 1 if a bot fails.")
    private boolean strict;

    @Mixin
    private final TimeLimitOptions pace = new TimeLimitOptions();

    @Mixin
    private final SandboxOptions sandbox = new SandboxOptions();

    @Override
    public Integer call() throws InterruptedException {
        return recorded == null && as == null ? newGames() : recordedGames();
    }

    private int newGames() throws InterruptedException {
        check.exclusive("--json", json, "--quiet", quiet);
        double factor = pace.factor();
        many.check(out != null, list.isGiven());
        list.check(seed.isGiven(), false);
        check.that(!overwrite || out != null || show.view() != null, "--overwrite: expected --out or --view with it");
        check.that(sign == null || out != null || show.isAny(), "--sign: expected --out with it");
        boolean piped = StandardFiles.is(out);
        check.that(!piped || !many.isAny(), "--out: found -, expected a folder with --games or --swap");
        check.that(!piped || !json, "--json is printed to the standard output, expected a file for --out");
        check.that(!StandardFiles.is(show.view()),
            "--view: found -, expected a file: the standard output is for the result");
        show.check(check, many.isAny());
        check.exclusive("--why", many.why(), "--quiet", quiet);
        check.that(level == null || level >= 1 && level <= MOST_LEVEL, "--league-level: found " + level
            + ", expected 1 to " + MOST_LEVEL);
        GameSetup setup = Games.warn(scene.open(streams), streams);
        setup = level == null ? setup : Games.types().inLeague(setup, level);
        int players = setup.scene().players();
        boolean alone = players == 1;
        String named = setup.scene().name();
        if (players == 0 && !bots.isEmpty()) {
            throw new InputException("found " + TextFormat.count(bots.size(), "bot") + ", expected none: the scene \""
                + named + "\" has no players; 'steward run " + scene.typed() + "' plays it");
        }
        if (bots.size() != players && !(alone && many.isAny() && !bots.isEmpty())) {
            throw new InputException("found " + TextFormat.count(bots.size(), "bot") + ", expected "
                + TextFormat.count(players, "bot") + ", one --bot for each player of the scene \"" + named + "\""
                + (alone && !bots.isEmpty() ? "; with --games several bots each play alone on the same maps" : ""));
        }
        String problem = alone ? many.problemAlone() : null;
        check.that(problem == null, problem);
        List<Path> own = folders.of("--bot");
        Contest contest = many.isAny() ? Contest.ofSeries(setup, bots, own, protocol, factor)
            : Contest.of(setup, bots, own, protocol, factor);
        contest = pace.limit(contest);
        contest = sign == null ? contest : contest.signedWith(SigningKey.read(OutputFiles.path(sign)));
        contest = contest.isolatedBy(sandbox.isolation(streams));
        List<String> choosers = list.choosers(contest.entrants());
        long first = alone && TestScores.count(setup) > 0 ? seed.or(1) : seed.orDrawn();
        Path path = out == null || piped ? null : OutputFiles.path(out);
        Verbosity report = json ? Verbosity.JSON : quiet ? Verbosity.LINE : Verbosity.FULL;
        if (many.isAny()) {
            Seeds starts = list.isGiven() ? list.seeds() : Seeds.from(first);
            Series series = new Series(contest, starts, count(), many.swap(), path, many.keep(), many.hiccups());
            SeriesRun run = new SeriesRun(streams, series, report, strict, many.random(), choosers, many.why(), page());
            if (many.into() == null) {
                return run.play(many.threads(streams), overwrite);
            }
            int threads = many.threads(streams);
            AtomicBoolean anew = new AtomicBoolean(overwrite);
            return StoredSeries.play(OutputFiles.path(many.into()), contest, factor, sandbox.variables(), streams,
                (league, watch) -> {
                    list.keepIn(OutputFiles.path(many.into()));
                    return run.play(threads, anew.getAndSet(true), league::add, watch);
                });
        }
        SingleMatch game = new SingleMatch(streams, contest, report, strict, piped, many.hiccups());
        return show.isAny() ? game.play(first, path, overwrite, show) : game.play(first, path, overwrite);
    }

    private SeriesPage page() {
        return SeriesPage.of(show.view(), show.open(), overwrite);
    }

    private int recordedGames() throws InterruptedException {
        check.exclusive("--json", json, "--quiet", quiet);
        check.that(recorded != null && as != null, "--recorded and --as are for each other, expected both");
        double factor = pace.factor();
        for (String name : OF_OTHER_GAMES) {
            check.that(!spec.commandLine().getParseResult().hasMatchedOption(name), "--recorded: found " + name
                + " with it, expected none: games are played as they were recorded");
        }
        many.check(false, true);
        check.that(bots.size() == 1, "--recorded: found " + TextFormat.count(bots.size(), "bot") + ", expected one");
        Supplier<Isolation> isolation = sandbox.isolation(streams);
        return new RecordedRun(streams, bots.get(0), folders.of("--bot").get(0), protocol, as,
            referee.types(), setup -> Contest.withoutBots(setup, factor).isolatedBy(isolation), pace,
            json ? Verbosity.JSON : quiet ? Verbosity.LINE : Verbosity.FULL, strict)
            .play(OutputFiles.path(recorded), many.threads(streams));
    }

    /** Number of seeds that are played: without {@code --games}, all of a list. */
    private int count() {
        if (list.isGiven() && many.areCounted()) {
            list.atLeast(many.games(), ", one for each of --games");
        }
        return list.isGiven() && !many.areCounted() ? list.seeds().count() : many.games();
    }
}
