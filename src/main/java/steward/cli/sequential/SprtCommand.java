package steward.cli.sequential;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import steward.cli.options.BotFolders;
import steward.cli.options.BuiltinBotWords;
import steward.cli.options.ProgramCommand;
import steward.cli.options.SandboxOptions;
import steward.cli.options.SceneOptions;
import steward.cli.options.SeedFileOption;
import steward.cli.options.SeedOption;
import steward.cli.options.ThreadsOption;
import steward.cli.options.TimeLimitOptions;
import steward.cli.play.StoredSeries;
import steward.cli.shared.ExitStatus;
import steward.cli.shared.Games;
import steward.cli.shared.Verbosity;
import steward.contest.Contest;
import steward.contest.Contest.Entrant;
import steward.contest.seeds.Seeds;
import steward.files.InputException;
import steward.files.OutputFiles;
import steward.game.GameSetup;
import steward.league.BotIdentity;
import steward.league.sequential.Gsprt;
import steward.league.sequential.ScoreCounts;
import steward.match.Protocol;
import steward.text.TextFormat;

/** {@code steward sprt}: tests sequentially whether the new bot is better than the old one. */
@Command(name = "sprt", description = "Plays two bots until it is clear whether the first is better.",
    footer = {
        "", "A sequential test (GSPRT) of two hypotheses: the first bot is stronger by elo0",
        "(H0) or by elo1 (H1). Each seed is played from all seats; the mean difference",
        "of the points of a seed counts. The test ends when one hypothesis is accepted,",
        "or after --games. With --into, stored games of the two bots count first, and",
        "the same command continues after an interruption.",
        "", "With --pool both bots meet the same opponents. Each seed draws one opponent,",
        "and both bots play it from all seats. The difference of their points a game",
        "counts.",
        "", "Examples:",
        "  steward sprt --bot new=./new --bot old=./old --threads auto",
        "  steward sprt --bot ./new --bot ./old --elo0 -5 --elo1 5 --into night",
        "  steward sprt --bot ./new --bot ./old --pool night --points1 0.03",
        "  steward sprt --penta 3,12,40,30,9",
        "", "Exit status: 0 decided, or --games were played; 1 games have no result, or a",
        "bot failed in 10 games in a row; 2 wrong call; 130 interrupted."})
public final class SprtCommand extends ProgramCommand {

    @Mixin
    private final SceneOptions scene = new SceneOptions();

    @Option(names = "--bot", paramLabel = "BOT", completionCandidates = BuiltinBotWords.class,
        description = "A bot: first the new one, then the old one.")
    private List<String> bots = new ArrayList<>();

    @Mixin
    private final BotFolders folders = new BotFolders();

    @Option(names = "--fill", paramLabel = "BOT", completionCandidates = BuiltinBotWords.class,
        description = "In a scene for three and more players: the bot that takes the other seats.")
    private String fill;

    @Option(names = "--protocol", paramLabel = "P", defaultValue = "json",
        description = "What bots without a prefix speak: json or codingame (default: ${DEFAULT-VALUE}).")
    private Protocol protocol;

    @Mixin
    private final SprtOptions options = new SprtOptions();

    @Mixin
    private final SeedOption seed = new SeedOption();

    @Mixin
    private final SeedFileOption list = new SeedFileOption();

    @Mixin
    private final ThreadsOption threads = new ThreadsOption();

    @Option(names = "--into", paramLabel = "DIR",
        description = "Stores the games in this league (see 'steward league'), and counts games that it already "
            + "has.")
    private String into;

    @Option(names = "--penta", paramLabel = "N,N,N,N,N", split = ",", description = "Plays nothing: computes the "
        + "test from the numbers of seeds (pairs of games) that gave 0, 1/2, 1, 3/2 and 2 points.")
    private List<String> penta = new ArrayList<>();

    @Option(names = "--wdl", paramLabel = "W,D,L", split = ",", description = "Plays nothing: computes the test "
        + "from the numbers of games won, drawn and lost.")
    private List<String> wdl = new ArrayList<>();

    @Option(names = "--json", description = "Prints one JSON object and nothing else.")
    private boolean json;

    @Option(names = "--quiet", description = "Prints only the line of the result.")
    private boolean quiet;

    @Mixin
    private final TimeLimitOptions pace = new TimeLimitOptions();

    @Mixin
    private final SandboxOptions sandbox = new SandboxOptions();

    @Override
    public Integer call() throws InterruptedException {
        check.exclusive("--json", json, "--quiet", quiet);
        list.check(seed.isGiven(), into != null);
        Gsprt test = options.test();
        threads.check();
        Verbosity report = json ? Verbosity.JSON : quiet ? Verbosity.LINE : Verbosity.FULL;
        if (!penta.isEmpty() || !wdl.isEmpty()) {
            check.exclusive("--penta", !penta.isEmpty(), "--wdl", !wdl.isEmpty());
            check.that(bots.isEmpty() && into == null && options.pool() == null, "found --bot, --pool or --into beside "
                + "counts, expected counts alone: "
                + "nothing is played");
            SprtRun.compute(streams, test, counts(), report);
            return ExitStatus.DONE;
        }
        double factor = pace.factor();
        check.that(bots.size() == 2, "--bot: found " + bots.size() + ", expected two: the new bot and the old one");
        GameSetup setup = Games.warn(scene.open(streams), streams);
        if (options.pool() != null) {
            return againstPool(setup, test, report, factor);
        }
        List<String> all = SprtOptions.withFill(check, bots, fill, setup.scene().players(), "are tested");
        List<Path> own = new ArrayList<>(folders.of("--bot"));
        folders.of("--fill").forEach(folder -> own.addAll(Collections.nCopies(all.size() - bots.size(), folder)));
        Contest contest = pace.limit(Contest.ofSeries(setup, all, own, protocol, factor))
            .isolatedBy(sandbox.isolation(streams));
        List<String> choosers = list.choosers(contest.entrants());
        if (into == null) {
            return new SprtRun(streams, contest, test, options.ending(), null, report).flagged(choosers, false)
                .play(list.isGiven() ? list.seeds() : Seeds.from(seed.orDrawn()), threads.count(streams),
                    StoredSeries.watch(contest, streams));
        }
        return StoredSeries.play(OutputFiles.path(into), contest, factor, sandbox.variables(), streams,
            (store, watch) -> {
                store.refuseTwins();
                list.keepIn(OutputFiles.path(into));
                return new SprtRun(streams, contest, test, options.ending(), store, report)
                    .flagged(choosers, list.isAnyway())
                    .play(list.isGiven() ? list.seeds() : Seeds.from(seed.or(store.ownSeed())), threads.count(streams),
                        watch);
            });
    }

    private int againstPool(GameSetup setup, Gsprt test, Verbosity report, double factor) throws InterruptedException {
        int players = setup.scene().players();
        check.that(fill == null, "--fill: expected none with --pool, whose bots take all other seats");
        check.that(players > 1, "--pool: found a scene for " + TextFormat.count(players, "player")
            + ", expected one for two or more");
        Path league = into == null ? null : OutputFiles.path(into);
        Protocol usual = setup.isGuest() ? Protocol.CODINGAME : protocol;
        List<Entrant> entrants = Pool.find(bots, folders.of("--bot"), options.pool(), league, usual);
        if (BotIdentity.ofProgram(entrants.get(0)).equals(BotIdentity.ofProgram(entrants.get(1)))) {
            throw new InputException("found the same program twice, as '" + entrants.get(0).name() + "' and as '"
                + entrants.get(1).name() + "', expected bots that differ in command or files");
        }
        Contest.checkPlayable(setup, entrants);
        check.that(entrants.size() - 2 >= players - 1, "--pool: found " + TextFormat.count(entrants.size() - 2, "bot")
            + ", expected at least " + (players - 1) + ", one for each other seat");
        Contest everyone = pace.limit(Contest.withoutBots(setup, factor).between(entrants))
            .isolatedBy(sandbox.isolation(streams));
        PoolText text = new PoolText(test, options.points0(), options.points1(), entrants.get(0).name(),
            entrants.get(1).name(), list.choosers(everyone.entrants().subList(0, 2)));
        if (league == null) {
            Seeds seeds = list.isGiven() ? list.seeds() : Seeds.from(seed.orDrawn());
            return new PoolRun(streams, everyone, test, options.ending(), text, seeds, null, report)
                .play(threads.count(streams), StoredSeries.watch(everyone, streams));
        }
        return StoredSeries.play(league, everyone, factor, sandbox.variables(), streams, (store, watch) -> {
            list.keepIn(league);
            return new PoolRun(streams, everyone, test, options.ending(), text, list.isGiven() ? list.seeds()
                : Seeds.from(seed.or(store.ownSeed())), store, report).play(threads.count(streams), watch);
        });
    }

    /** Counts that were given: the lowest score first. */
    private ScoreCounts counts() {
        boolean isPenta = !penta.isEmpty();
        List<String> words = isPenta ? penta : wdl;
        int expected = isPenta ? 5 : 3;
        boolean isRight = words.size() == expected && words.stream().allMatch(word -> word.matches("[0-9]{1,12}"));
        check.that(isRight && words.stream().anyMatch(word -> Long.parseLong(word) > 0),
            (isPenta ? "--penta" : "--wdl") + ": found '" + String.join(",", words) + "', expected " + expected
            + " numbers of " + (isPenta ? "pairs with 0, 1/2, 1, 3/2 and 2 points, such as 3,12,40,30,9"
            : "games that were won, drawn and lost, such as 120,30,90"));
        ScoreCounts scores = new ScoreCounts(isPenta ? 2 : 1);
        for (int k = 0; k < expected; k++) {
            scores.add((double) k / (expected - 1), Long.parseLong(words.get(isPenta ? k : expected - 1 - k)));
        }
        return scores;
    }
}
