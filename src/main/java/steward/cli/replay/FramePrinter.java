package steward.cli.replay;

import steward.bot.LineBuffer;
import steward.cli.shared.FailedException;
import steward.cli.streams.Streams;
import steward.game.GameTypes;
import steward.replay.RecordedTurn;
import steward.replay.ReplayException;
import steward.replay.ReplayReader;
import steward.replay.feed.Feed;
import steward.replay.feed.SentLines;

/** Printer of the lines that one bot was sent in a recorded match. */
final class FramePrinter {

    /**
     * A bot that failed was sent the turn it failed in, and nothing after it; one that was out by the rules was sent no
     * more turns, but the end.
     *
     * @param player counted from 0
     * @param only   the turn of which the lines are printed, of the first with those before it; {@code null} for all
     * @throws FailedException if the replay does not say what the game gives, from that turn on
     */
    static void print(Streams streams, ReplayReader replay, int player, Integer only, GameTypes types) {
        SentLines frames = new SentLines(replay, types);
        if (only == null || only == 1) {
            print(streams, frames.setup(player));
        }
        boolean failed = false;
        int last = 0;
        for (RecordedTurn turn = replay.next(); turn != null && !streams.outEnded(); turn = replay.next()) {
            last = turn.number();
            LineBuffer lines = frames.turn(player, turn);
            if (lines != null && (only == null || only == last)) {
                print(streams, lines);
            }
            if (only != null && only == last) {
                return;
            }
            failed |= turn.faults()[player] != null;
            play(frames, turn);
        }
        if (only != null) {
            throw TurnDetail.noSuchTurn(replay, only, last);
        }
        if (replay.ending() != null && !failed) {
            print(streams, frames.end(player));
        }
    }

    private static void play(SentLines frames, RecordedTurn turn) {
        try {
            Feed.play(frames.match(), turn);
        } catch (ReplayException differs) {
            throw new FailedException(differs.getMessage());
        }
    }

    private static void print(Streams streams, LineBuffer frame) {
        streams.out().write(frame.bytes(), 0, frame.size());
    }
}
