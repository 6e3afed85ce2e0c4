package steward.contest;

import java.io.OutputStream;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import steward.bot.Player;
import steward.bot.UnstartablePlayer;
import steward.bot.command.Program;
import steward.bot.command.SiteJavaScript;
import steward.bot.isolation.Isolation;
import steward.bot.isolation.Launch;
import steward.bot.process.BotProcess;
import steward.contest.Contest.Entrant;
import steward.files.JarFolder;
import steward.match.MatchListener;
import steward.match.MatchResult;
import steward.match.Protocol;
import steward.match.Referee;
import steward.match.Seat;
import steward.match.TeeListener;
import steward.replay.ReplayHeader;
import steward.replay.ReplayWriter;
import steward.replay.sign.SigningKey;
import steward.scene.Time;

/**
 * Preparation of a contest's matches: it starts the bots, opens the replay and signs it.
 *
 * @param key       signs replays; or {@code null}
 * @param isolation how bots are kept apart, asked for when bots are started
 * @param starter   starts bots
 */
public record Staging(SigningKey key, Supplier<Isolation> isolation, BotStarter starter) {

    /** Replays are not signed, bots are processes in the usual isolation. */
    static final Staging USUAL = new Staging(null, Isolation::usual, Staging::process);

    Staging signedWith(SigningKey other) {
        return new Staging(other, isolation, starter);
    }

    Staging isolatedBy(Supplier<Isolation> other) {
        return new Staging(key, other, starter);
    }

    Staging startedBy(BotStarter other) {
        return new Staging(key, isolation, other);
    }

    /** A bot that is not started yet. @param others the programs of the other bots, which it must not see */
    Player player(Entrant entrant, List<Program> others) {
        return starter.player(entrant, isolation.get(), others);
    }

    private static Player process(Entrant entrant, Isolation isolation, List<Program> others) {
        if (entrant.problem() != null) {
            return new UnstartablePlayer(entrant.name(), entrant.problem());
        }
        Program program = entrant.protocol() == Protocol.CODINGAME
            ? entrant.program().started(SiteJavaScript.words(entrant.words())) : entrant.program();
        return new BotProcess(entrant.name(), new Launch(program,
            entrant.isBuiltin() ? isolation.withoutMemoryLimit() : isolation, others), BotProcess.DEFAULT_GRACE_MS);
    }

    /**
     * Plays a match as {@link Contest#play} does.
     *
     * @param seated the bots by their seats
     */
    MatchResult play(Contest contest, List<Entrant> seated, long seed, OutputStream recording, MatchListener follower)
            throws InterruptedException {
        List<Seat> seats = new ArrayList<>();
        Map<Integer, Time> limits = contest.limits(seated);
        for (Entrant entrant : seated) {
            List<Program> others = contest.entrants().stream()
                .filter(each -> each != entrant && each.problem() == null).map(Entrant::program).toList();
            seats.add(new Seat(player(entrant, others), entrant.protocol(), limits.get(seats.size())));
        }
        MatchListener listener = recording == null ? follower
            : new TeeListener(new ReplayWriter(recording, header(contest, seed, seated), key,
                isolation.get().text()), follower);
        return Referee.of(contest.setup(), seed, seats, contest.time(), listener).play();
    }

    private static ReplayHeader header(Contest contest, long seed, List<Entrant> seated) {
        return new ReplayHeader(contest.setup().scene().gameId(), contest.setup().scene().json(), seed,
            seated.stream().map(Entrant::name).toList(), seated.stream().map(Entrant::bot).toList(),
            seated.stream().map(Entrant::protocol).toList(), contest.timeFactor(), contest.setup().plan().lawVersion(),
            null, contest.sandbox(), JarFolder.digestOf(contest.setup()), contest.limits(seated));
    }
}
