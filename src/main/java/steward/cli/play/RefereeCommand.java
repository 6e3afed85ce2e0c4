package steward.cli.play;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import steward.cli.options.AccuracyOption;
import steward.cli.options.ProgramCommand;
import steward.cli.options.SandboxOptions;
import steward.cli.options.SceneOptions;
import steward.cli.options.ShippedScenes;
import steward.cli.options.TimeLimitOptions;
import steward.cli.shared.Games;
import steward.cli.shared.RefusedCall;
import steward.contest.Contest;
import steward.files.OutputFiles;
import steward.game.GameSetup;
import steward.game.GameType;
import steward.match.Protocol;
import steward.scene.json.SceneException;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ObjectNode;

/** {@code steward referee}: stands in for another referee in the community's arena tools. */
@Command(name = "referee", description = "Plays one match as the referee of cg-brutaltester and tools like it: "
    + "prints one whole number per player, in order. Higher is better; a negative number means that the bot "
    + "failed.",
    footer = {
        "", "A bot is a command, quoted as in a shell, that speaks CodinGame's text",
        "protocol; 'json:COMMAND' speaks JSON. Four bots come with the program, from",
        "weak to strong: 'builtin:racer', 'builtin:regular', 'builtin:contender' and",
        "'builtin:veteran'. A bot that cannot be started has failed, and the others win.",
        "The number of bots in -p1 to -p4 is the number of players, if the scene's game",
        "allows several.",
        "", "If a bot lost a game on time while others used the processors, it is played",
        "again, as in 'match'. The standard error says why, and why a bot failed. If the",
        "call is refused, each named bot gets -1.",
        "", "Files of -l and -r are replaced if they are empty or of the same kind, since",
        "tools use the same names again. Any other file is kept, and the call refused.",
        "", "Examples:",
        "  steward referee -p1 ./mine -p2 'python3 other.py' -d seed=7 -l game.json",
        "  java -jar cg-brutaltester.jar -r 'steward referee' -p1 ./mine -p2 ./other \\",
        "      -n 100 -s",
        "", "Exit status: 0 there is a result; 1 there is none; 2 wrong call."})
public final class RefereeCommand extends ProgramCommand implements RefusedCall {

    private CommandSpec spec;

    @Option(names = "-d", paramLabel = "KEY=VALUE",
        description = "seed=N: the seed of the game's random numbers (default: a random seed). Other keys are "
            + "ignored.")
    private List<String> data = new ArrayList<>();

    @Option(names = {"-seed", "--seed"}, paramLabel = "N", description = "The same as -d seed=N.")
    private Long seed;

    @Option(names = "-l", paramLabel = "FILE", description = "Writes the match as CodinGame's game result in JSON.")
    private String log;

    @Option(names = "-r", paramLabel = "FILE", description = "Writes the replay, which 'steward replay' reads.")
    private String replay;

    @Option(names = "-s", description = "Makes a page that shows the match, and prints its address after the "
        + "scores.")
    private boolean page;

    @Option(names = {"-scene", "--scene"}, paramLabel = "FILE|NAME", defaultValue = SceneOptions.USUAL,
        completionCandidates = ShippedScenes.class, description = SceneOptions.DESCRIPTION)
    private String scene;

    @Mixin
    private final AccuracyOption accuracy = new AccuracyOption();

    @Option(names = {"-league", "-lvl"}, paramLabel = "N",
        description = "The league whose rules apply: 1 (lowest) to 4 for Mean Max, 1 to 3 for Fantastic Bits; a "
            + "higher number means the highest. Without it, with 0 and in other games the scene's rules apply.")
    private Integer league;

    @Mixin
    private final TimeLimitOptions pace = new TimeLimitOptions();

    @Mixin
    private final SandboxOptions sandbox = new SandboxOptions();

    /** The command with the options of its players, which have numbers in their names. */
    public static CommandSpec spec() {
        RefereeCommand command = new RefereeCommand();
        command.spec = CommandSpec.forAnnotatedObject(command);
        command.spec.parser().posixClusteredShortOptionsAllowed(false);
        RefereeArguments.addPlayers(command.spec);
        return command.spec;
    }

    @Override
    public Integer call() throws InterruptedException {
        RefereeArguments arguments = new RefereeArguments(spec);
        Long inData = RefereeArguments.seed(data);
        check.that(seed == null || inData == null || seed.equals(inData),
            "found two seeds, " + seed + " and " + inData + ", expected one");
        check.that(league == null || league >= 0, "-league: found " + league + ", expected 0 or more");
        double factor = pace.factor();
        Long wanted = seed != null ? seed : inData;
        GameSetup setup = seated(open(), arguments.players());
        List<String> bots = arguments.bots(setup.scene().players(), setup.scene().name());
        Contest contest = pace.limit(named(Contest.withFailing(setup, bots, Protocol.CODINGAME, factor), arguments));
        check.that(log == null || !log.isBlank(), "-l: found no name of a file, expected one");
        check.that(replay == null || !replay.isBlank(), "-r: found no name of a file, expected one");
        Path logFile = log == null ? null : OutputFiles.path(log);
        Path replayFile = replay == null ? null : OutputFiles.path(replay);
        check.that(logFile == null || replayFile == null
            || !logFile.toAbsolutePath().normalize().equals(replayFile.toAbsolutePath().normalize()),
            "-l and -r: found " + log + " twice, expected two files");
        RefereeFiles.check(logFile, replayFile, page);
        for (int player = 0; player < contest.entrants().size(); player++) {
            String problem = contest.entrants().get(player).problem();
            if (problem != null) {
                streams.warn("-p" + (player + 1) + " has failed, because it cannot be started: " + problem);
            }
        }
        return new RefereeGame(streams, contest.isolatedBy(sandbox.isolation(streams)), logFile, replayFile, page)
            .play(wanted);
    }

    private GameSetup open() {
        GameSetup setup = accuracy.open(scene, streams);
        boolean own = league == null || league == 0;
        return Games.warn(own ? setup : Games.types().inLeague(setup, league), streams);
    }

    /** The scene for as many players as are named, where its game allows that; otherwise the scene as it is. */
    private static GameSetup seated(GameSetup setup, int players) {
        int most = Games.types().of(setup.scene().gameId()).map(GameType::mostOnSite).orElse(0);
        if (players < 2 || players > most || players == setup.scene().players()) {
            return setup;
        }
        ObjectNode scene = (ObjectNode) JsonMapper.shared().readTree(setup.scene().json());
        try {
            return Games.types().open(scene.put("players", players).toString(), setup.scene().name());
        } catch (SceneException notForSoMany) {
            return setup;
        }
    }

    /** A tool that finds no scores takes the match for a draw: each bot that the call names gets -1. */
    @Override
    public void refuse(List<String> arguments) {
        arguments.stream().filter(RefereeArguments::isPlayer).map(argument -> argument.replaceFirst("=.*", ""))
            .distinct().forEach(player -> streams.out().println(-1));
        streams.out().flush();
    }

    private static Contest named(Contest contest, RefereeArguments arguments) {
        List<Contest.Entrant> entrants = new ArrayList<>();
        for (int player = 0; player < contest.entrants().size(); player++) {
            Contest.Entrant entrant = contest.entrants().get(player);
            String name = arguments.nameOf(player);
            entrants.add(name == null ? entrant : entrant.named(name));
        }
        return contest.between(entrants);
    }
}
