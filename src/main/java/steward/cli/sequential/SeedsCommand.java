package steward.cli.sequential;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
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
import steward.cli.options.SeedOption;
import steward.cli.options.ThreadsOption;
import steward.cli.options.TimeLimitOptions;
import steward.cli.play.FailureReport;
import steward.cli.play.StoredSeries;
import steward.cli.shared.ExitStatus;
import steward.cli.shared.FailedException;
import steward.cli.shared.Games;
import steward.cli.streams.Interruption;
import steward.cli.streams.ProgressLine;
import steward.contest.Contest;
import steward.contest.FailureCounts;
import steward.contest.FailureStreaks;
import steward.contest.Hiccups;
import steward.contest.PairedPlay;
import steward.contest.ProgramWatch;
import steward.contest.seeds.SeedFile;
import steward.contest.seeds.Seeds;
import steward.files.OutputFiles;
import steward.game.GameSetup;
import steward.league.BotIdentity;
import steward.match.Protocol;
import steward.text.TextFormat;

/** {@code steward seeds}: chooses seeds that tell bots apart and are fair to all seats. */
@Command(name = "seeds", description = "Chooses seeds that tell bots apart and are fair to both sides.",
    footer = {
        "", "The two bots play each seed from all seats. If one bot is ahead in every seat,",
        "the seed tells them apart; if the seat decides, it does not. The file has one",
        "seed a line, and comments on how they were chosen. These games count nowhere.",
        "Tests of the two bots on these seeds are refused, because the result on them",
        "was known before.",
        "", "Example:",
        "  steward seeds --bot builtin:regular --bot builtin:contender --count 200 \\",
        "      --from 2000 --out chosen.txt",
        "  steward sprt --bot ./new --bot ./old --seed-file chosen.txt",
        "", "Exit status: 0 done, also if fewer were found; 1 none was found, or a bot",
        "failed in 10 games in a row; 2 wrong call; 130 interrupted."})
public final class SeedsCommand extends ProgramCommand {

    private static final int MOST = 1_000_000;

    @Mixin
    private final SceneOptions scene = new SceneOptions();

    @Option(names = "--bot", paramLabel = "BOT", completionCandidates = BuiltinBotWords.class,
        description = "A bot whose games choose the seeds; give two.")
    private List<String> bots = new ArrayList<>();

    @Mixin
    private final BotFolders folders = new BotFolders();

    @Option(names = "--fill", paramLabel = "BOT", completionCandidates = BuiltinBotWords.class,
        description = "In a scene for three and more players: the bot that takes the other seats.")
    private String fill;

    @Option(names = "--protocol", paramLabel = "P", defaultValue = "json",
        description = "What bots without a prefix speak: json or codingame (default: ${DEFAULT-VALUE}).")
    private Protocol protocol;

    @Option(names = "--count", paramLabel = "N", defaultValue = "200",
        description = "How many are chosen (default: ${DEFAULT-VALUE}).")
    private Integer count;

    @Option(names = "--from", paramLabel = "N", defaultValue = "2000",
        description = "How many are tried at most (default: ${DEFAULT-VALUE}).")
    private Integer from;

    @Mixin
    private final SeedOption seed = new SeedOption();

    @Option(names = "--out", paramLabel = "FILE", description = "Writes the seeds to this file (default: the "
        + "standard output).")
    private String out;

    @Option(names = "--overwrite", description = "Replaces the file if it exists.")
    private boolean overwrite;

    @Mixin
    private final ThreadsOption threads = new ThreadsOption();

    @Mixin
    private final TimeLimitOptions pace = new TimeLimitOptions();

    @Mixin
    private final SandboxOptions sandbox = new SandboxOptions();

    private final FailureStreaks streaks = new FailureStreaks();

    @Override
    public Integer call() throws InterruptedException {
        check.range("--count", count, 1, MOST);
        check.range("--from", from, 1, MOST);
        check.that(from >= count, "--from: found " + from + ", expected at least --count, which is " + count);
        check.that(!overwrite || out != null, "--overwrite: expected --out with it");
        threads.check();
        double factor = pace.factor();
        check.that(bots.size() == 2, "--bot: found " + bots.size() + ", expected two: those whose games choose");
        GameSetup setup = Games.warn(scene.open(streams), streams);
        List<String> all = SprtOptions.withFill(check, bots, fill, setup.scene().players(), "choose");
        List<Path> own = new ArrayList<>(folders.of("--bot"));
        folders.of("--fill").forEach(folder -> own.addAll(Collections.nCopies(all.size() - bots.size(), folder)));
        Contest contest = pace.limit(Contest.ofSeries(setup, all, own, protocol, factor))
            .isolatedBy(sandbox.isolation(streams));
        Path path = out == null ? null : OutputFiles.path(out);
        if (path != null) {
            OutputFiles.check(path, overwrite);
        }
        long first = seed.orDrawn();
        SeedChoice choice = play(contest, first);
        if (choice == null) {
            return ExitStatus.FAILED;                  // interrupted
        }
        int found = choice.lines().size();
        if (found == 0) {
            throw new FailedException("no seed tells these bots apart: " + String.join(" ", choice.account()));
        }
        write(path, String.join("\n", text(contest, first, choice)) + "\n");
        if (found < count) {
            streams.err().println("steward: found " + found + " of " + TextFormat.count(count, "seed")
                + "; with more than --from " + from + " there may be more");
        }
        return ExitStatus.DONE;
    }

    private List<String> text(Contest contest, long first, SeedChoice choice) {
        List<String> lines = new ArrayList<>();
        lines.add("# Seeds of " + TextFormat.plain(contest.sceneName()) + " from " + first
            + " on, chosen by 'steward seeds'");
        contest.entrants().subList(0, 2).forEach(bot -> lines.add(SeedFile.chooser(BotIdentity.ofProgram(bot),
            TextFormat.plain(bot.name()))));
        choice.account().forEach(each -> lines.add("# " + each));
        lines.addAll(choice.lines());
        return lines;
    }

    private void write(Path path, String text) {
        if (path == null) {
            streams.out().print(text);
            streams.out().flush();
            return;
        }
        try {
            OutputFiles.replace(path, text.getBytes(StandardCharsets.UTF_8));
        } catch (IOException problem) {
            throw new FailedException(path + ": cannot be written: " + OutputFiles.reason(path, problem));
        }
    }

    /** Plays until there are enough; {@code null} if it was interrupted. */
    private SeedChoice play(Contest contest, long first) throws InterruptedException {
        SeedChoice choice = new SeedChoice(contest, count);
        ProgramWatch watch = StoredSeries.watch(contest, streams);
        FailureCounts failures = new FailureCounts(contest);
        ProgressLine progress = ProgressLine.watched(streams, "seeds", from);
        int[] left = {from};
        PairedPlay play = new PairedPlay(contest, Seeds.from(first), Hiccups.REPLAY, (any, rotation) -> null,
            game -> { }, failures, watch, games -> {
                streaks.add(contest, games);
                boolean isMore = choice.take(games);
                progress.step(choice.best() + " chosen");
                return isMore && --left[0] > 0 && streaks.failing() == null;
            });
        try (Interruption interruption = new Interruption(streams, () -> {
                play.breakOff();
                progress.close();
                return "nothing is written";
            })) {
            play.play(threads.count(streams));
            if (!interruption.over()) {
                return null;
            }
        } finally {
            progress.close();
        }
        FailureReport.print(streams.err(), streams.errColour(), contest, failures.kinds());
        if (watch.changed() != null) {
            throw new FailedException(watch.changed() + " has changed: seeds are chosen by games of one version of "
                + "each bot");
        }
        if (streaks.failing() != null) {
            throw new FailedException("the choice ends: " + TextFormat.plain(streaks.failing()) + " failed in "
                + FailureStreaks.MOST + " games in a row");
        }
        return choice;
    }
}
