package steward.replay.feed;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.UnaryOperator;
import steward.bot.Answer;
import steward.bot.LineBuffer;
import steward.game.Game;
import steward.game.GameJson;
import steward.game.GameSetup;
import steward.game.GameTypes;
import steward.match.Dialogue;
import steward.match.DialoguePlayer;
import steward.match.MatchListener;
import steward.match.MatchResult;
import steward.match.Referee;
import steward.match.Seat;
import steward.match.TimeControl;
import steward.match.Turn;
import steward.replay.RecordedMatch;
import steward.replay.RecordedTurn;
import steward.replay.verify.Resimulation;
import tools.jackson.core.JsonParser;

/**
 * A recorded match played again with a bot in the seat of one player. The others answer as recorded, as long as they
 * are sent what they were sent. At the first other line nobody knows what they would have answered, and the match is
 * broken off. The recorded match is played beside it, since its lines follow from it.
 */
public final class Rematch {

    /** Ending of a rematch. */
    public enum Ending {
        /** The match came to its end, and all others were sent what they were sent. */
        UNCHANGED,
        /** Somebody would have been sent something else, or the recording ends. */
        DEPARTED,
        /** The bot failed. */
        FAILED
    }

    /**
     * The result.
     *
     * @param turn   the last one that was played; of a departure, that which was not, and of a failure, its own
     * @param reason of a departure or failure, otherwise {@code null}
     * @param result {@code null} after a departure
     */
    public record Outcome(Ending ending, int turn, String reason, MatchResult result) { }

    /** The others would have been sent something else. */
    private static final class Departure extends RuntimeException {

        Departure(String reason) {
            super(reason, null, false, false);
        }
    }

    private final RecordedMatch match;
    private final int seat;
    private final GameSetup setup;
    private final SentLines sent;
    private Game game;
    private String fault;
    private int failed;

    /**
     * Opens the match.
     *
     * @param types    for playing; a guest's referee is run
     * @param recorded for what was recorded; a guest's referee only says again what it said
     * @param seat     of the player in whose place the bot plays
     * @throws steward.replay.ReplayException if it cannot be played again
     */
    public Rematch(RecordedMatch match, GameTypes types, GameTypes recorded, int seat) {
        this.match = match;
        this.seat = seat;
        setup = new Resimulation(match.header(), null, types, match.source()).setup();
        sent = new SentLines(match.header(), new Resimulation(match.header(), match.start(), recorded, match.source()));
    }

    /** The scene of the match. */
    public GameSetup setup() {
        return setup;
    }

    /**
     * Plays. Call once.
     *
     * @param bot      with its protocol and limits
     * @param isolated the scene with its referee kept apart
     * @throws steward.replay.ReplayException if the match cannot be played again as it was recorded
     */
    public Outcome play(Seat bot, TimeControl time, UnaryOperator<GameSetup> isolated) throws InterruptedException {
        List<Seat> seats = new ArrayList<>();
        for (int player = 0; player < match.header().names().size(); player++) {
            seats.add(player == seat ? bot : new Seat(new Recorded(player), match.header().protocols().get(player)));
        }
        Follower follower = new Follower();
        try {
            MatchResult result = Referee.of(isolated.apply(setup), match.header().seed(), seats, time, follower)
                .play();
            fault = fault == null ? result.players().get(seat).fault() : fault;
            return new Outcome(fault == null ? Ending.UNCHANGED : Ending.FAILED, failed > 0 ? failed : result.turns(),
                fault, result);
        } catch (Departure departure) {
            return fault == null ? new Outcome(Ending.DEPARTED, game.turn() + 1, departure.getMessage(), null)
                : new Outcome(Ending.FAILED, failed, fault, null);
        } finally {
            sent.match().game().close();
        }
    }

    /** The recorded turn that is played next. */
    private RecordedTurn next() {
        if (game.turn() >= match.turns().size()) {
            throw new Departure("the recording ends");
        }
        return match.turns().get(game.turn());
    }

    private boolean wasAsked(RecordedTurn turn, int player) {
        return sent.match().game().isAsked(player) && turn.asked(player);
    }

    private String nameOf(int player) {
        return match.header().names().get(player);
    }

    /** Plays the recorded turn beside each that is played. */
    private final class Follower implements MatchListener {

        @Override
        public void start(Game started, GameJson codec) {
            game = started;
        }

        @Override
        public void commands(Turn turn) {
            if (failed == 0 && turn.fault(seat) != null) {
                failed = turn.number();
                fault = turn.fault(seat);
            }
            RecordedTurn recorded = next();
            for (int player = 0; player < turn.players(); player++) {
                if (fault == null && player != seat && wasAsked(recorded, player) && !turn.asked(player)) {
                    throw new Departure(nameOf(player) + " is not asked");
                }
            }
        }

        @Override
        public void played(Turn turn) {
            Feed.play(sent.match(), match.turns().get(turn.number() - 1));
        }
    }

    /** A player that answers as recorded, and is sent lines to be compared. */
    private final class Recorded implements DialoguePlayer, Dialogue {

        private final int player;
        private GameJson codec;
        private Dialogue dialogue;
        private boolean isOther;

        Recorded(int player) {
            this.player = player;
        }

        @Override
        public Dialogue in(Game played) {
            codec = setup.codec(played);
            dialogue = Dialogue.of(match.header().protocols().get(player), setup, played, codec,
                match.header().limits());
            return this;
        }

        @Override
        public String name() {
            return nameOf(player);
        }

        @Override
        public LineBuffer setup(int number) {
            return dialogue.setup(number);
        }

        @Override
        public void tell(byte[] lines, int length) {
            isOther = !isSame(sent.setup(player), lines, length);
        }

        @Override
        public LineBuffer turn(int number) {
            return dialogue.turn(number);
        }

        @Override
        public LineBuffer end(int number) {
            return dialogue.end(number);
        }

        @Override
        public int answerLines(int number) {
            return dialogue.answerLines(number);
        }

        @Override
        public Ending ask(byte[] frame, int length, int answerLines, long limitNanos, Answer answer) {
            RecordedTurn turn = next();
            if (!wasAsked(turn, player)) {
                throw new Departure(name() + " was not asked");
            }
            if (isOther || !isSame(sent.turn(player, turn), frame, length)) {
                throw new Departure(name() + " is sent other lines");
            }
            answer.clear();
            answer.setStderr(turn.stderr()[player]);
            if (turn.faults()[player] == null) {
                return Ending.ANSWERED;
            }
            codec.clearCommand(player);
            try (JsonParser in = turn.command(player)) {
                if (in != null) {
                    codec.readPartialCommand(in, player);
                }
            }
            answer.setFault(turn.faults()[player]);
            return Ending.FAULT;
        }

        private static boolean isSame(LineBuffer then, byte[] now, int length) {
            return then != null && Arrays.equals(then.bytes(), 0, then.size(), now, 0, length);
        }

        @Override
        public String readAnswer(int number, byte[] answer, int length) {
            try (JsonParser in = next().command(number)) {
                return in == null ? "found no recorded command" : codec.readCommand(in, number);
            }
        }

        @Override
        public String message(int number) {
            return next().messages()[number];
        }
    }
}
