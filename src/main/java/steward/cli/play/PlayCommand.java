package steward.cli.play;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import steward.cli.options.BuiltinBotWords;
import steward.cli.options.ProgramCommand;
import steward.cli.options.SandboxOptions;
import steward.cli.options.SceneOptions;
import steward.cli.options.SeedOption;
import steward.cli.options.TimeLimitOptions;
import steward.cli.shared.ExitStatus;
import steward.cli.shared.FailureReason;
import steward.cli.shared.Games;
import steward.cli.streams.Json;
import steward.codingame.LeagueAttributes;
import steward.codingame.RatingToolJson;
import steward.contest.Contest;
import steward.contest.CountedGame;
import steward.files.InputException;
import steward.files.OutputFiles;
import steward.game.GameSetup;
import steward.match.MatchResult;
import steward.match.Protocol;
import steward.text.TextFormat;

/** {@code steward play}: plays one match for a rating tool. */
@Command(name = "play", description = "Plays one match as the game command of psyleague and tools like it: prints "
    + "one JSON object with ranks, errors and the data that bots report.",
    footer = {
        "", "A bot is a command, quoted as in a shell, that speaks CodinGame's text",
        "protocol; 'json:COMMAND' speaks JSON. Four bots come with the program, from",
        "weak to strong: 'builtin:racer', 'builtin:regular', 'builtin:contender' and",
        "'builtin:veteran'. A bot that cannot be started has failed, and the match has a",
        "result.",
        "", "The object has the fields:",
        "  ranks         0 for the best",
        "  errors        1 for a bot that failed",
        "  faults        the reason, with its stderr, or null",
        "  test_data     the seed, and data about the match",
        "  player_data, attributes, played_again",
        "If a bot lost a game on time while others used the processors, it is played",
        "again, as in 'match'; played_again and the standard error say why. Bots report",
        "data on stderr:",
        "  [TDATA] name = value         about the match",
        "  [PDATA] name = value         about the bot itself",
        "  [PDATA+] name = value        about the bot itself, summed up",
        "  [PDATA][turn] name = value   about a turn",
        "", "Example, in psyleague.cfg:",
        "  cmd_play_game = \"steward play --json-league %%DIR%%/%%P1%% %%DIR%%/%%P2%%\"",
        "", "Exit status: 0 there is a result, also if a bot failed; 1 there is none; 2",
        "wrong call."})
public final class PlayCommand extends ProgramCommand {

    @Option(names = "--json-league", required = true, description = "Prints the result in this form, the only one.")
    private boolean league;

    @Parameters(paramLabel = "BOT", completionCandidates = BuiltinBotWords.class,
        description = "The bots, one for each player of the scene; see below.")
    private List<String> bots = new ArrayList<>();

    @Option(names = "--out", paramLabel = "FILE",
        description = "Writes the replay to this file, which is replaced if it is empty or a replay.")
    private String out;

    @Mixin
    private final SeedOption seed = new SeedOption();

    @Mixin
    private final SceneOptions scene = new SceneOptions();

    @Mixin
    private final TimeLimitOptions pace = new TimeLimitOptions();

    @Mixin
    private final SandboxOptions sandbox = new SandboxOptions();

    @Override
    public Integer call() throws InterruptedException, IOException {
        GameSetup setup = Games.warn(scene.open(streams), streams);
        int players = setup.scene().players();
        if (bots.size() != players) {
            throw new InputException("found " + TextFormat.count(bots.size(), "bot") + ", expected "
                + TextFormat.count(players, "bot") + ", one for each player of the scene");
        }
        Contest contest = pace.limit(Contest.withFailing(setup, bots, Protocol.CODINGAME, pace.factor()))
            .isolatedBy(sandbox.isolation(streams));
        Path replay = out == null ? null : OutputFiles.path(out);
        RefereeFiles.checkReplay("--out ", replay);
        long used = seed.orDrawn();
        CountedGame<LeagueAttributes> game = CountedGame.play(contest, used, LeagueAttributes::new,
            () -> replay == null ? null : OutputFiles.open(replay, true));
        RefereeGame.tell(streams, game);
        RefereeGame.tell(streams, contest, game.failures(), player -> contest.entrants().get(player).name());
        String[] faults = game.result().players().stream().map(MatchResult.PlayerResult::fault).toArray(String[]::new);
        game.failures().forEach(failure -> faults[failure.player()] += FailureReason.said(failure));
        Json.print(streams, RatingToolJson.of(used, game.result(), faults, game.follower())
            .with("played_again", game.again()));
        return ExitStatus.DONE;
    }
}
