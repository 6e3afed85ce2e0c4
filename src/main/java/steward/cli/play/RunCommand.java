package steward.cli.play;

import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Supplier;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import steward.bot.isolation.Isolation;
import steward.cli.options.AccuracyOption;
import steward.cli.options.DisplayOptions;
import steward.cli.options.ProgramCommand;
import steward.cli.options.SeedOption;
import steward.cli.options.ShippedScenes;
import steward.cli.shared.ExitStatus;
import steward.cli.shared.FailedException;
import steward.cli.shared.Games;
import steward.cli.streams.Interruption;
import steward.cli.streams.Json;
import steward.cli.streams.ProgressLine;
import steward.contest.Contest;
import steward.contest.ReplayFile;
import steward.files.InputException;
import steward.files.OutputFiles;
import steward.game.GameSetup;
import steward.match.MatchResult;
import steward.report.Fields;

/** {@code steward run}: runs a scene without players. */
@Command(name = "run", description = "Plays a scene without players, such as one of bodies, and prints energy, "
    + "momenta, temperature, pressure and impacts by turn.",
    footer = {
        "", "--csv writes three tables, with units in the first line (masses in m, lengths",
        "in u):",
        "  turns.csv    sums of every turn",
        "  states.csv   every body but bumpers at the end of every turn",
        "  impacts.csv  normal, velocities before and after, energy gained",
        "Numbers have full precision: they read back as the same doubles. Ids count",
        "listed bodies, then rows of the scene's csv, then its fills in order, then",
        "bumpers. If a scene names a states.csv as its \"csv\", it begins with the last",
        "turn there and continues with the same bits.",
        "", "--json: scene, seed, turns, ending, and rows with the sums of each turn:",
        "  energy            kinetic; with forces a, of the speed v + a/2",
        "  momentumX, momentumY, angularMomentum (about the origin)",
        "  impacts           their number",
        "  potential         minus the work of the forces since the start",
        "  limitTime         when the turn reached the bound on impacts",
        "  rest, restSum     energy that rest took beyond restitution; its sum",
        "  temperature       energy of a body, on average",
        "  pressureWalls     impulses on walls and bumpers, divided by their length",
        "  pressureVirial    (energy + half the sum of impulse times distance of the",
        "                    centres, at a wall the radius) divided by the area",
        "If a force acts, rest is 0 and pressureVirial null.",
        "", "Examples:",
        "  steward run gas --seed 7 --view gas.html --open",
        "  steward run bowl --turns 200 --accuracy exact --out bowl.jsonl --csv bowl",
        "  steward replay bowl.jsonl --verify",
        "", "Exit status: 0 it was played to its end; 1 it was not; 2 wrong call."})
public final class RunCommand extends ProgramCommand {

    @Parameters(index = "0", paramLabel = "SCENE", completionCandidates = ShippedScenes.class,
        description = "A file, - for the standard input, or the name of a shipped scene.")
    private String scene;

    @Option(names = "--turns", paramLabel = "N", description = "Plays at most N turns, in place of the scene's bound.")
    private Integer turns;

    @Mixin
    private final AccuracyOption accuracy = new AccuracyOption();

    @Mixin
    private final SeedOption seed = new SeedOption();

    @Option(names = "--out", paramLabel = "FILE", description = "Writes the replay to this file.")
    private String out;

    @Option(names = "--csv", paramLabel = "DIR", description = "Writes tables into this folder.")
    private String csv;

    @Option(names = "--json", description = "Prints one JSON object instead; see below.")
    private boolean json;

    @Option(names = "--overwrite", description = "Replaces replays, pages and tables that exist.")
    private boolean overwrite;

    @Mixin
    private final DisplayOptions show = new DisplayOptions();

    @Override
    public Integer call() throws InterruptedException {
        check.that(turns == null || turns > 0, "--turns: found " + turns + ", expected 1 or more");
        check.that(!overwrite || out != null || csv != null || show.view() != null,
            "--overwrite: expected --out, --csv or --view with it");
        show.check(check, false);
        GameSetup setup = Games.warn(accuracy.open(scene, streams), streams);
        int players = setup.scene().players();
        if (players > 0) {
            throw new InputException("found a scene for " + players + " players, expected one for 0: 'steward match' "
                + "plays it between bots");
        }
        setup = turns == null ? setup : Games.withTurns(setup, turns);
        Path path = out == null ? null : OutputFiles.path(out);
        long used = seed.orDrawn();
        try (RunTables tables = RunTables.open(csv == null ? null : OutputFiles.path(csv), overwrite)) {
            Contest contest = Contest.withoutBots(tables.watching(setup), Double.POSITIVE_INFINITY)
                .isolatedBy(() -> Isolation.OFF);
            if (!show.isAny()) {
                play(contest, used, path, null, tables);
                return ExitStatus.DONE;
            }
            try (MatchDisplay display = MatchDisplay.prepare(streams, streams.out(), show, contest.sceneName(), path,
                    overwrite)) {
                display.awaitViewer();
                play(contest, used, path, display, tables);
                display.finish();
            }
        }
        return ExitStatus.DONE;
    }

    private void play(Contest contest, long used, Path path, MatchDisplay display, RunTables tables)
            throws InterruptedException {
        MatchResult result;
        try (ReplayFile recording = path == null ? null : new ReplayFile(path, overwrite);
             Interruption hint = new Interruption(streams, path == null && csv == null ? null : () -> {
                 tables.close();
                 return "the turns so far are in " + (path == null ? csv : csv == null ? path : path + " and " + csv);
             });
             ProgressLine progress = ProgressLine.watched(streams, "turns", contest.setup().mostTurns())) {
            OutputStream written = display == null ? recording : display.with(recording);
            Supplier<String> standing = tables::standing;                // made once, not for each turn
            result = contest.play(used, 0, written, tables.following(() -> progress.step(standing)));
            hint.over();
            if (recording != null && recording.isBroken()) {
                throw new FailedException(recording.problem());
            }
        } catch (UncheckedIOException problem) {
            throw new FailedException("the scene could not be played to its end: " + problem.getMessage());
        }
        if (json) {
            Json.print(streams, Fields.of("scene", contest.sceneName(), "seed", used, "turns", result.turns(),
                "ending", result.ending(), "rows", tables.json()));
            return;
        }
        streams.out().println(contest.sceneName() + ", seed " + used + ", "
            + contest.setup().scene().accuracy().text() + ": " + result.turns() + " turns, " + result.ending());
        tables.lines().forEach(streams.out()::println);
        List.of(path == null ? "" : "Replay: " + path, csv == null ? "" : "Tables: " + csv).stream()
            .filter(line -> !line.isEmpty()).forEach(streams.out()::println);
    }
}
