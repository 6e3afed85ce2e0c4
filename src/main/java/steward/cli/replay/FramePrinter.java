package steward.cli.replay;

import steward.bot.LineBuffer;
import steward.cli.shared.FailedException;
import steward.cli.streams.Streams;
import steward.game.GameTypes;
import steward.match.Dialogue;
import steward.replay.RecordedTurn;
import steward.replay.ReplayException;
import steward.replay.ReplayReader;
import steward.replay.feed.Feed;
import steward.replay.verify.Resimulation;

/**
 * Prints the lines that one bot was sent in a recorded match. They follow from the game, which is played again; the
 * referee of a guest says what is recorded.
 */
final class FramePrinter {

    /**
     * A bot that failed was sent the turn it failed in, and nothing after it; one that was out by the rules was sent no
     * more turns, but the end.
     *
     * @param player counted from 0
     * @throws FailedException if the replay does not say what the game gives, from that turn on
     */
    static void print(Streams streams, ReplayReader replay, int player, GameTypes types) {
        Resimulation again = new Resimulation(replay.header(), replay.start(), types, replay.source());
        Dialogue frames = Dialogue.of(replay.header().protocols().get(player), again.setup(),
            again.game(), again.codec());
        print(streams, frames.setup(player));
        boolean failed = false;
        for (RecordedTurn turn = replay.next(); turn != null && !streams.outEnded(); turn = replay.next()) {
            if (again.game().isAsked(player) && turn.asked(player)) {
                print(streams, frames.turn(player));
            }
            failed |= turn.faults()[player] != null;
            play(again, turn);
        }
        if (replay.ending() != null && !failed) {
            print(streams, frames.end(player));
        }
    }

    private static void play(Resimulation again, RecordedTurn turn) {
        try {
            Feed.play(again, turn);
        } catch (ReplayException differs) {
            throw new FailedException(differs.getMessage());
        }
    }

    private static void print(Streams streams, LineBuffer frame) {
        streams.out().write(frame.bytes(), 0, frame.size());
    }
}
