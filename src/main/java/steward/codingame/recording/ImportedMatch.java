package steward.codingame.recording;

import java.io.OutputStream;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.stream.IntStream;
import steward.bot.Player;
import steward.codingame.recording.RecordingImport.Imported;
import steward.game.FrameCodec;
import steward.game.Game;
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

/**
 * Makes a replay of ours of a recorded match: the recorded lines are played by our referee as if bots had just said
 * them, and what the server saw is kept in place of our own outcomes, so that verifying the replay compares our rules
 * and physics with the server's.
 */
final class ImportedMatch {

    private final GameSetup setup;
    private final long seed;
    private final ServerObservations observed;
    private final GameFacts facts;
    private final List<Player> players;

    ImportedMatch(GameSetup setup, long seed, ServerObservations observed, GameFacts facts,
                  List<? extends Player> players) {
        this.setup = setup;
        this.seed = seed;
        this.observed = observed;
        this.facts = facts;
        this.players = List.copyOf(players);
    }

    Imported write(OutputStream out) throws InterruptedException {
        List<Seat> seats = players.stream().map(player -> new Seat(player, Protocol.CODINGAME)).toList();
        List<String> names = players.stream().map(Player::name).toList();
        ReplayHeader header = new ReplayHeader(setup.scene().gameId(), setup.scene().json(), seed, names,
            Collections.nCopies(names.size(), "recorded"), Collections.nCopies(names.size(), Protocol.CODINGAME),
            Double.POSITIVE_INFINITY).ofLaw(setup.plan().lawVersion());
        Recorder recorder = new Recorder(new ReplayWriter(out, header, observed).untimed());
        try {
            MatchResult result = Referee.of(setup, seed, seats, TimeControl.UNLIMITED, recorder).play();
            return new Imported(recorder.turns, result.ending());
        } catch (RecordingEnds end) {
            if (observed.isOver()) {
                recorder.writer.end(over(names));
            }
            return new Imported(recorder.turns, null);
        }
    }

    /** The result of a game that the server has ended, but our rules have not: verification will say so. */
    private MatchResult over(List<String> names) {
        return told(observed.turns(), "the recording ends", IntStream.range(0, names.size()).mapToObj(player ->
            new MatchResult.PlayerResult(names.get(player), observed.rank(player), 0, null, null, 0, 0, 0, 0, 0))
            .toList());
    }

    /** With what the site tells of game and players. */
    private MatchResult told(int turns, String ending, List<MatchResult.PlayerResult> results) {
        List<MatchResult.PlayerResult> players = new ArrayList<>();
        for (MatchResult.PlayerResult of : results) {
            players.add(new MatchResult.PlayerResult(of.name(), of.rank(), of.score(), of.fault(), of.out(),
                of.answers(), 0, 0, 0, of.earlyTurns(), facts.players().get(players.size())));
        }
        return new MatchResult(turns, ending, players, facts.data());
    }

    /** The recording has no more turns, but by our rules the game goes on. */
    private static final class RecordingEnds extends RuntimeException {

        RecordingEnds() {
            super("the recording ends", null, false, false);
        }
    }

    /** Passes a match on to a writer as far as it was recorded. */
    private final class Recorder implements MatchListener {

        private final ReplayWriter writer;
        private int turns;

        Recorder(ReplayWriter writer) {
            this.writer = writer;
        }

        @Override
        public void start(Game game, FrameCodec codec) {
            observed.start(game);
            writer.start(game, codec);
        }

        @Override
        public void commands(Turn turn) {
            if (turn.number() > observed.turns()) {
                throw new RecordingEnds();
            }
            writer.commands(turn);
        }

        @Override
        public void played(Turn turn) {
            writer.played(turn);
            turns++;
        }

        /** The result counts the turns that the server played after the end by our rules. */
        @Override
        public void end(MatchResult result) {
            int all = observed.turns();
            while (all > turns && observed.isSilent(all)) {
                all--;
            }
            writer.end(told(all, result.ending(), result.players()));
        }
    }
}
