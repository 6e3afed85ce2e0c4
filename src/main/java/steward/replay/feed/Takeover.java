package steward.replay.feed;

import java.io.OutputStream;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.IntConsumer;
import java.util.stream.IntStream;
import steward.bot.Player;
import steward.game.Game;
import steward.game.GameTypes;
import steward.match.MatchResult;
import steward.match.Protocol;
import steward.match.Stopwatch;
import steward.match.Turn;
import steward.replay.RecordedMatch;
import steward.replay.RecordedTurn;
import steward.replay.ReplayException;
import steward.replay.ReplayHeader;
import steward.replay.ReplayWriter;
import steward.replay.verify.Resimulation;

/**
 * Takeover of one player of a recorded match by a bot, recorded as a new match. The others play their recorded
 * commands. Before the given turn the bot is sent the recorded game and the recorded commands are played; from that
 * turn on its own commands are played.
 *
 * <p>The others do not react: their recorded commands are applied unchanged. The match ends by the rules, or when a
 * remaining player has neither a command nor a fault recorded; then the new recording has no result.
 */
public final class Takeover {

    /**
     * The result.
     *
     * @param turns  how many the new recording has
     * @param result or {@code null} if there is none
     * @param reason why there is none, or {@code null}
     * @param ahead  names of the players that were ahead at the end, several if they tie
     */
    public record Outcome(int turns, MatchResult result, String reason, List<String> ahead) { }

    private final RecordedMatch match;
    private final List<String> names;
    private final int from;
    private final FeedDialogue dialogue;
    private final Resimulation again;
    private final Game game;
    private final ReplayWriter writer;
    private final Stopwatch[] watches;
    private final String[] faults;

    /**
     * As {@link Feed}.
     *
     * @param asked its name stands in the new recording, with the player's number where another player has it
     * @param from  first turn that the bot plays; the player is in then
     * @param bot   how it was called
     * @param out   for the new recording
     */
    public Takeover(RecordedMatch match, GameTypes types, int player, Protocol protocol, Player asked, int from,
                    String bot, OutputStream out) {
        this.match = match;
        this.from = from;
        again = new Resimulation(match.header(), null, types, match.source());
        dialogue = new FeedDialogue(again, player, protocol, asked, match.header().limits());
        game = again.game();
        names = names(match.header().names(), player, asked.name());
        writer = new ReplayWriter(out, header(match.header(), names, player, protocol, bot));
        watches = new Stopwatch[game.players()];
        faults = new String[game.players()];
        for (int k = 0; k < watches.length; k++) {
            watches[k] = new Stopwatch();
        }
    }

    private static List<String> names(List<String> recorded, int player, String name) {
        List<String> names = new ArrayList<>(recorded);
        names.set(player, null);
        String own = name;
        while (names.contains(own)) {
            own += "-" + player;
        }
        names.set(player, own);
        return names;
    }

    /** The header of the new match: the same, but with another bot, without deadlines and unsigned. */
    private static ReplayHeader header(ReplayHeader recorded, List<String> names, int player, Protocol protocol,
                                       String bot) {
        List<String> bots = new ArrayList<>(recorded.bots());
        bots.set(player, bot);
        List<Protocol> protocols = new ArrayList<>(recorded.protocols());
        protocols.set(player, protocol);
        return new ReplayHeader(recorded.game(), recorded.scene(), recorded.seed(), names, bots, protocols,
            Double.POSITIVE_INFINITY, recorded.law(), null).ofJar(recorded.jar())
            .ofLimits(recorded.limits());
    }

    /**
     * Plays.
     *
     * @param before is told each turn before it is sent to the bot
     * @param after  is told what the bot did
     * @throws ReplayException if the match cannot be played again up to the turn
     */
    public Outcome run(IntConsumer before, Consumer<FedTurn> after) {
        writer.start(game, again.codec());
        for (RecordedTurn recorded : match.turns()) {
            boolean replaced = recorded.number() >= from;
            String missing = replaced ? missing(recorded) : null;
            if (missing != null) {
                return unfinished(missing);
            }
            FedTurn fed = null;
            if (isAsked(recorded, replaced)) {
                before.accept(recorded.number());
                fed = dialogue.ask(recorded, replaced);
                after.accept(fed);
            }
            if (fed != null && fed.gone() && !replaced) {
                return unfinished("the bot has ended before turn " + from);
            }
            String problem = replaced ? play(recorded, fed) : playAgain(recorded);
            if (problem != null) {
                return unfinished(problem);
            }
            if (game.isOver()) {
                return finished();
            }
        }
        return unfinished("the recording ends");
    }

    private boolean isAsked(RecordedTurn recorded, boolean replaced) {
        int player = dialogue.player();
        return dialogue.isIn() && (replaced ? !again.isDecided(player, recorded.faults())
            : recorded.asked(player));
    }

    /**
     * Names one of the other players that has to answer but has neither a command nor a fault in this turn; or
     * {@code null}.
     */
    private String missing(RecordedTurn recorded) {
        for (int other = 0; other < game.players(); other++) {
            if (other != dialogue.player() && game.isAsked(other) && !recorded.hasCommand(other)
                && recorded.faults()[other] == null && !again.isDecided(other, othersFaults(recorded))) {
                return "of " + match.header().names().get(other) + " no command was recorded in turn "
                    + recorded.number();
            }
        }
        return null;
    }

    private String[] othersFaults(RecordedTurn recorded) {
        String[] faults = recorded.faults().clone();
        faults[dialogue.player()] = null;
        return faults;
    }

    private String playAgain(RecordedTurn recorded) {
        Feed.requireSame(recorded, again.prepare(recorded));
        Turn turn = Turn.of(recorded.number(), game.players());
        for (int player = 0; player < game.players(); player++) {
            recorded.tell(turn, player);
        }
        play(turn);
        Feed.checkHash(game, recorded);
        return null;
    }

    /** @return {@code null}, or why the turn cannot be played */
    private String play(RecordedTurn recorded, FedTurn fed) {
        String wrong = readOthers(recorded);
        if (wrong != null) {
            return wrong;
        }
        Turn turn = Turn.of(recorded.number(), game.players());
        for (int player = 0; player < game.players(); player++) {
            if (player != dialogue.player()) {
                if (game.isAsked(player)) {
                    recorded.tell(turn, player);
                    if (turn.fault(player) != null) {
                        game.eliminate(player, turn.fault(player));      // a recorded fault is repeated
                    }
                }
            } else if (fed != null && fed.fault() == null) {
                turn.answer(player, dialogue.message(), dialogue.answer().stderr(),
                    dialogue.answer().nanos());
            } else if (fed != null) {
                turn.fail(player, fed.fault(), dialogue.answer().stderr(), dialogue.answer().nanos());
                game.eliminate(player, turn.fault(player));
            }
        }
        play(turn);
        return null;
    }

    private String readOthers(RecordedTurn recorded) {
        String wrong = null;
        for (int player = 0; player < game.players() && wrong == null; player++) {
            if (player != dialogue.player() && game.isAsked(player) && recorded.hasCommand(player)) {
                wrong = again.readCommand(recorded, player);
            }
        }
        return wrong;
    }

    private void play(Turn turn) {
        for (int player = 0; player < turn.players(); player++) {
            if (turn.asked(player)) {
                watches[player].add(turn.nanos(player));
            }
            faults[player] = turn.fault(player) == null ? faults[player] : turn.fault(player);
        }
        writer.commands(turn);
        game.play();
        writer.played(turn);
    }

    private Outcome finished() {
        int[] ranks = game.ranks();
        double[] scores = game.scores();
        List<MatchResult.PlayerResult> players = new ArrayList<>();
        for (int player = 0; player < ranks.length; player++) {
            Stopwatch watch = watches[player];
            players.add(new MatchResult.PlayerResult(names.get(player), ranks[player],
                scores[player], faults[player], game.eliminationReason(player), watch.answers(), watch.averageNanos(),
                watch.worstNanos(), watch.firstNanos(), 0));
        }
        MatchResult result = new MatchResult(game.turn(), game.ending(), players);
        writer.end(result);
        if (faults[dialogue.player()] == null) {
            dialogue.end();
        }
        return new Outcome(game.turn(), result, null, ahead());
    }

    private Outcome unfinished(String reason) {
        return new Outcome(game.turn(), null, reason, ahead());
    }

    private List<String> ahead() {
        int[] ranks = game.ranks();
        return IntStream.range(0, ranks.length).filter(player -> ranks[player] == 0).mapToObj(names::get).toList();
    }
}
