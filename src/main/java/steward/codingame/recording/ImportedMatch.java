package steward.codingame.recording;

import java.io.OutputStream;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.stream.IntStream;
import steward.bot.Player;
import steward.codingame.recording.RecordingImport.Imported;
import steward.files.JarFolder;
import steward.game.Game;
import steward.game.GameJson;
import steward.game.GameSetup;
import steward.match.MatchListener;
import steward.match.MatchResult;
import steward.match.Protocol;
import steward.match.Referee;
import steward.match.Seat;
import steward.match.TimeControl;
import steward.match.Turn;
import steward.replay.ReplayHeader;
import steward.replay.ReplayWriter;
import steward.replay.ServerRecording;

/**
 * Recorded match of CodinGame's server, converted to a replay of ours. Our referee plays the recorded lines as if bots
 * had just said them. The server's frames are kept beside, so that verifying the replay compares our rules and physics
 * with the server's.
 */
final class ImportedMatch {

    private final GameSetup setup;
    private final long seed;
    private final Frames frames;
    private final ServerRecording.End end;
    private final RecordingFacts facts;
    private final List<Player> players;

    /** The frames of a recording, turn by turn; turn 0 is the start. */
    interface Frames {

        /** True if the recording has the answers of a turn. */
        boolean has(int turn);

        /** The frames of the turn just played; asked for once, in order. */
        List<ServerRecording.Frame> of(int turn, Game game);

        /** All frames behind those of a turn. */
        List<ServerRecording.Frame> behind(int turn);
    }

    /** The recording has no more turns, but by our rules the game goes on. */
    static final class RecordingEnds extends RuntimeException {

        RecordingEnds() {
            super("the recording ends", null, false, false);
        }
    }

    /** @param end what the server says of the whole game; without ranks and scores it goes on */
    ImportedMatch(GameSetup setup, long seed, Frames frames, ServerRecording.End end,
                  RecordingFacts facts, List<? extends Player> players) {
        this.setup = setup;
        this.seed = seed;
        this.frames = frames;
        this.end = end;
        this.facts = facts;
        this.players = List.copyOf(players);
    }

    Imported write(OutputStream out) throws InterruptedException {
        List<Seat> seats = players.stream().map(player -> new Seat(player, Protocol.CODINGAME)).toList();
        List<String> names = players.stream().map(Player::name).toList();
        ReplayHeader header = new ReplayHeader(setup.scene().gameId(), setup.scene().json(), seed, names,
            Collections.nCopies(names.size(), "recorded"), Collections.nCopies(names.size(), Protocol.CODINGAME),
            Double.POSITIVE_INFINITY).ofLaw(setup.plan().lawVersion()).ofJar(JarFolder.digestOf(setup));
        ServerRecording server = new ServerRecording();
        Recorder recorder = new Recorder(new ReplayWriter(out, header, server).untimed(), server);
        try {
            // A referee that asks for times is told them as those of its own limits.
            MatchResult result = Referee.of(setup, seed, seats, setup.isGuest()
                ? TimeControl.of(setup.scene().time(), 1) : TimeControl.UNLIMITED, recorder).play();
            return new Imported(recorder.turns, result.ending());
        } catch (RecordingEnds recordingEnds) {
            if (end.ranks() != null || end.scores() != null) { // by our rules it goes on: verification will say so
                recorder.end(new MatchResult(recorder.turns, recordingEnds.getMessage(), IntStream.range(0,
                    names.size()).mapToObj(player -> new MatchResult.PlayerResult(names.get(player), 0, 0, null, null,
                        0, 0, 0, 0, 0)).toList()));
            }
            return new Imported(recorder.turns, null);
        }
    }

    /** Passes a match on to a writer as far as it was recorded. */
    private final class Recorder implements MatchListener {

        private final ReplayWriter writer;
        private final ServerRecording server;
        private Game game;
        private int turns;

        Recorder(ReplayWriter writer, ServerRecording server) {
            this.writer = writer;
            this.server = server;
        }

        @Override
        public void start(Game started, GameJson codec) {
            game = started;
            server.add(frames.of(0, game));
            writer.start(game, codec);
        }

        @Override
        public void commands(Turn turn) {
            if (!frames.has(turn.number())) {
                throw new RecordingEnds();
            }
            writer.commands(turn);
        }

        @Override
        public void played(Turn turn) {
            turns++;
            server.add(frames.of(turns, game));
            writer.played(turn);
        }

        /** Adds what the site tells of game and players, and what the server has shown behind the end by our rules. */
        @Override
        public void end(MatchResult result) {
            List<MatchResult.PlayerResult> told = new ArrayList<>();
            for (MatchResult.PlayerResult of : result.players()) {
                told.add(new MatchResult.PlayerResult(of.name(), of.rank(), of.score(), of.fault(), of.out(),
                    of.answers(), 0, 0, 0, of.earlyTurns(), facts.players().get(told.size())));
            }
            server.end(new ServerRecording.End(Math.max(end.turns(), turns), frames.behind(turns), end.ranks(),
                end.scores(), end.input(), end.data()));
            writer.end(new MatchResult(result.turns(), result.ending(), told, facts.data()));
        }
    }
}
