package steward.match;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.ExecutionException;
import steward.bot.Answer;
import steward.bot.Burner;
import steward.bot.LineBuffer;
import steward.bot.Player;
import steward.bot.process.DaemonThreadPool;
import steward.game.Game;
import steward.game.GameJson;
import steward.game.GameSetup;
import steward.scene.Time;

/**
 * The loop of a match: each turn it asks the players for commands and lets the game play the turn. It sends every
 * player a frame, takes commands one player after another, eliminates players that failed, and notifies the listener.
 * All remaining players are asked every turn, also after another has failed. Only if that fault decides the game is the
 * turn not played.
 *
 * <p>The loop runs on a thread that does nothing else, one of {@link DaemonThreadPool}. When a player can neither be
 * read nor killed, that thread is blocked. The player then hands the fault to a new thread, which goes on with the next
 * player; the blocked thread, if it ever returns, exits without changing anything. All state of the loop is therefore
 * in fields, handed over by the player with a happens-before edge.
 */
public final class Referee {

    private final Game game;
    private final GameJson codec;
    private final List<Player> players;
    /** True if a player may block the thread that asks it. */
    private final boolean mayBlock;
    private final Dialogue[] dialogues;
    private final DataLineCollector data;
    private final TimeControl time;
    /** Limits of players that have their own. */
    private final Map<Integer, Time> limits = new HashMap<>();
    private final MatchListener listener;
    private final CompletableFuture<MatchResult> result = new CompletableFuture<>();

    private final Turn turn;
    private final Answer[] answers;
    private final Stopwatch[] watches;
    private final String[] faults;
    private final int[] earlyTurns;
    private final int[] heldFrom;
    /** Limits of the answers that are asked for, in nanoseconds. */
    private final long[] limitNanos;
    private int next;

    /**
     * A match between players who all use JSON.
     *
     * @param players as many as the scene has, in order; they are finished when the match is over
     * @throws IllegalArgumentException if their number is not the scene's
     */
    public Referee(GameSetup setup, long seed, List<? extends Player> players, TimeControl time,
                   MatchListener listener) {
        this(players.stream().map(player -> new Seat(player, Protocol.JSON)).toList(), setup, seed, time, listener);
    }

    /**
     * A match between players who may use different protocols.
     *
     * @param seats as many as the scene has players, in order; the players are finished when the match is over
     * @throws IllegalArgumentException if their number is not the scene's, or its game does not support a protocol
     */
    public static Referee of(GameSetup setup, long seed, List<Seat> seats, TimeControl time, MatchListener listener) {
        return new Referee(List.copyOf(seats), setup, seed, time, listener);
    }

    private Referee(List<Seat> seats, GameSetup setup, long seed, TimeControl time, MatchListener listener) {
        game = setup.create(seed);
        if (seats.size() != game.players()) {
            throw new IllegalArgumentException(seats.size() + " bots, expected " + game.players()
                + ": the scene \"" + setup.scene().name() + "\" is for " + game.players() + " players");
        }
        codec = setup.codec(game);
        players = seats.stream().map(Seat::player).toList();
        mayBlock = players.stream().anyMatch(Player::mayBlock);
        for (int player = 0; player < seats.size(); player++) {
            if (seats.get(player).limits() != null) {
                limits.put(player, seats.get(player).limits());
            }
        }
        dialogues = dialogues(seats, setup);
        this.time = time;
        this.listener = listener;
        int count = players.size();
        data = new DataLineCollector(count);
        turn = new Turn(count);
        answers = new Answer[count];
        watches = new Stopwatch[count];
        faults = new String[count];
        earlyTurns = new int[count];
        heldFrom = new int[count];
        limitNanos = new long[count];
        for (int player = 0; player < count; player++) {
            int number = player;
            answers[player] = new Answer();
            watches[player] = new Stopwatch();
            players.get(player).limitBy(time.basis());
            players.get(player).onAbandoned(answer -> goOnAfter(number, answer));
        }
    }

    /** One dialogue per protocol, shared by its players; some players have their own. */
    private Dialogue[] dialogues(List<Seat> seats, GameSetup setup) {
        Map<Protocol, Dialogue> spoken = new EnumMap<>(Protocol.class);
        Dialogue[] each = new Dialogue[seats.size()];
        for (int player = 0; player < each.length; player++) {
            each[player] = seats.get(player).dialogue(game, protocol -> spoken.computeIfAbsent(protocol,
                word -> Dialogue.of(word, setup, game, codec, limits)));
        }
        return each;
    }

    /**
     * Plays the match. Call once. If no player may block, the calling thread plays.
     *
     * @throws InterruptedException if the calling thread is interrupted; the players are finished then
     * @throws RuntimeException     whatever the game or the listener threw; the players are finished then
     */
    public MatchResult play() throws InterruptedException {
        try {
            if (mayBlock) {
                DaemonThreadPool.run(this::begin);
            } else {
                begin();
            }
            return result.get();
        } catch (ExecutionException problem) {
            if (problem.getCause() instanceof RuntimeException unchecked) {
                throw unchecked;
            }
            throw new CompletionException(problem.getCause());
        } catch (InterruptedException interrupted) {
            result.completeExceptionally(interrupted);
            players.forEach(Player::close);
            game.close();
            throw interrupted;
        }
    }

    private void begin() {
        guarded(() -> {
            listener.start(game, codec);
            for (int player = 0; player < players.size(); player++) {
                LineBuffer frame = dialogues[player].setup(player);
                players.get(player).tell(frame.bytes(), frame.size());
            }
            turn.begin(1);
            askRest();
        });
    }

    /** Runs on a new thread: the previous one is blocked in this player, whose fault is known by now. */
    private void goOnAfter(int player, Answer answer) {
        guarded(() -> {
            if (result.isDone()) {
                return;
            }
            take(player, Player.Ending.FAULT, answer);
            next = player + 1;
            askRest();
        });
    }

    private void guarded(Runnable work) {
        try {
            work.run();
        } catch (Throwable problem) {              // errors too: the thread that awaits the result must see them
            try {
                players.forEach(Player::close);
            } finally {
                game.close();
                result.completeExceptionally(problem);
            }
        }
    }

    /** Plays from the next player to the end of the match, or until another thread has taken the match over. */
    private void askRest() {
        while (!result.isDone() && (mayBlock || !Thread.currentThread().isInterrupted())) {
            for (; next < players.size() && !game.isDecided(); next++) {
                if (game.isAsked(next) && !ask(next)) {
                    return;
                }
            }
            playTurn();
            if (game.isOver()) {
                finish();
                return;
            }
            next = 0;
            turn.begin(game.turn() + 1);
        }
    }

    /** @return false if this thread must leave */
    private boolean ask(int player) {
        int gameMs = game.limitMs(player);
        long limit = time.limit(limits.get(player), gameMs, watches[player].answers());
        limitNanos[player] = limit;
        if (game.strikeMs(player) > 0) {
            players.get(player).strikeAfter(TimeControl.allowed(game.strikeMs(player), limit, gameMs));
        }
        LineBuffer frame = dialogues[player].turn(player);
        Player.Ending ending = players.get(player).ask(frame.bytes(), frame.size(),
            dialogues[player].answerLines(player), limit, answers[player]);
        if (ending == Player.Ending.ABANDONED || result.isDone()) {
            return false;                           // done: the players were closed meanwhile, which is no fault
        }
        take(player, ending, answers[player]);
        return true;
    }

    private void take(int player, Player.Ending ending, Answer answer) {
        watches[player].add(answer.nanos());
        earlyTurns[player] += answer.extraLines() > 0 ? 1 : 0;
        turn.asked[player] = true;
        turn.answers[player] = answer;
        turn.nanos[player] = answer.nanos();
        turn.timeSpent[player] = answer.timeSpent();
        if (answer.held() && heldFrom[player] == 0) {
            heldFrom[player] = turn.number();
        }
        turn.stderr[player] = SafeText.wellFormed(answer.stderr());
        data.read(player, turn.stderr[player]);
        game.timed(player, TimeControl.counted(answer.nanos(), limitNanos[player], game.limitMs(player)));
        String fault = answer.fault();
        if (ending == Player.Ending.ANSWERED) {
            String wrong = dialogues[player].readAnswer(player, answer.bytes(), answer.length());
            fault = wrong == null ? null : SafeText.fault(wrong, answer.bytes(), answer.length());
        }
        if (fault == null) {
            turn.answered[player] = true;
            turn.messages[player] = SafeText.wellFormed(dialogues[player].message(player));
        } else {
            faults[player] = SafeText.wellFormed(fault);
            turn.faults[player] = faults[player];
            turn.burners[player] = answer.timeSpent() == null ? null : burner(player, answer.nanos());
            game.eliminate(player, faults[player]);
            players.get(player).close();
        }
    }

    /** The bot that used most while this one was asked, if one burned; {@code null} if none did. */
    private Burner burner(int late, long sinceNanos) {
        Burner most = null;
        for (int player = 0; player < players.size(); player++) {
            Burner found = player == late ? null : players.get(player).burner(sinceNanos);
            if (found != null && (most == null || found.processors() > most.processors())) {
                most = new Burner(player, found.processors(), found.holdable());
            }
        }
        return most;
    }

    private void playTurn() {
        listener.commands(turn);
        game.play();
        listener.played(turn);
    }

    private void finish() {
        int[] ranks = game.ranks();
        double[] scores = game.scores();
        for (int player = 0; player < players.size(); player++) {
            faults[player] = faults[player] != null ? faults[player] : SafeText.wellFormed(game.expulsion(player));
        }
        game.close();
        for (int player = 0; player < players.size(); player++) {
            LineBuffer frame = dialogues[player].end(player);
            players.get(player).sendLastLines(frame.bytes(), frame.size());
        }
        for (int player = 0; player < players.size(); player++) {
            LineBuffer frame = dialogues[player].end(player);
            players.get(player).finish(frame.bytes(), frame.size());
            data.read(player, players.get(player).finalStderr());
        }
        data.end();
        List<MatchResult.PlayerResult> results = new ArrayList<>();
        for (int player = 0; player < players.size(); player++) {
            Stopwatch watch = watches[player];
            results.add(new MatchResult.PlayerResult(players.get(player).name(), ranks[player], scores[player],
                faults[player], game.eliminationReason(player), watch.answers(), watch.averageNanos(),
                watch.worstNanos(), watch.firstNanos(), earlyTurns[player], data.player(player), heldFrom[player]));
        }
        MatchResult matchResult = new MatchResult(game.turn(), game.ending(), results, data.match());
        listener.end(matchResult);
        result.complete(matchResult);
    }
}
