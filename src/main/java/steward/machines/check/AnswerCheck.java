package steward.machines.check;

import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import steward.bot.FaultMessages;
import steward.bot.Player;
import steward.contest.Contest;
import steward.contest.Contest.Entrant;
import steward.game.GameTypes;
import steward.replay.RecordedMatch;
import steward.replay.ReplayHeader;
import steward.replay.feed.FedTurn;
import steward.replay.feed.Feed;
import steward.replay.verify.Resimulation;

/**
 * Check that asks a deterministic bot the questions of a finished game again, without deadlines, and compares answer by
 * answer. A missed deadline cannot be repeated and proves nothing.
 */
public final class AnswerCheck {

    /** How long a bot may take for a whole game that it has played within its limits before, in seconds. */
    private static final long PATIENCE_S = 600;

    private final Contest contest;
    private final GameTypes types;
    private final String scene;

    /** @param contest of the scene, with the isolation in which bots are asked */
    public AnswerCheck(Contest contest, GameTypes types) {
        this.contest = contest;
        this.types = types;
        scene = contest.setup().scene().json();
    }

    /**
     * An answer that is not the recorded one.
     *
     * @param text      where, what was recorded, and what the bot answers here
     * @param failsHere true if the bot fails here and was not recorded to
     */
    public record Otherwise(String text, boolean failsHere) { }

    /**
     * Asks a bot again.
     *
     * @param entrant how it is started here
     * @return the first answer that is not the recorded one, or {@code null}
     */
    public Otherwise difference(RecordedMatch match, int player, Entrant entrant) {
        Player bot = contest.player(entrant);
        Otherwise[] found = {null};
        Resimulation again = again(match);
        CompletableFuture<Void> end = CompletableFuture.runAsync(bot::close,
            CompletableFuture.delayedExecutor(PATIENCE_S, TimeUnit.SECONDS));
        try {
            new Feed(match, again, player, entrant.protocol(), bot).run(lastRepeatable(match, player),
                turn -> { }, turn -> found[0] = found[0] == null ? difference(turn) : found[0]);
        } finally {
            end.cancel(false);
            bot.close();
            again.game().close();
        }
        return found[0];
    }

    /** Opens the scene of a match only if it is another one than that of the contest. */
    private Resimulation again(RecordedMatch match) {
        ReplayHeader header = match.header();
        return header.scene().equals(scene)
            ? new Resimulation(contest.setup(), header.seed()) : new Resimulation(header, null, types, match.source());
    }

    /** The last turn before one in which it was late: there it might never answer. */
    private static int lastRepeatable(RecordedMatch match, int player) {
        return match.turns().stream().filter(turn -> turn.faults()[player] != null
            && FaultMessages.isTime(turn.faults()[player])).mapToInt(turn -> turn.number() - 1).findFirst()
            .orElse(Integer.MAX_VALUE);
    }

    /** Compares a turn; {@code null} if the answer is the recorded one. */
    private static Otherwise difference(FedTurn turn) {
        String recorded = turn.recordedFault();
        if (!turn.differences().isEmpty()) {
            return new Otherwise(turn.differences().get(0).toString(), false);
        }
        boolean same = turn.fault() == null ? recorded == null
            : recorded != null && FaultMessages.withoutTimes(turn.fault()).equals(FaultMessages.withoutTimes(recorded));
        return same ? null : new Otherwise("turn " + turn.number() + ": found "
            + (recorded == null ? "a command" : "the fault '" + recorded + "'") + ", expected "
            + (turn.fault() == null ? "a command" : "the fault '" + turn.fault() + "'"),
            turn.fault() != null && recorded == null);
    }
}
