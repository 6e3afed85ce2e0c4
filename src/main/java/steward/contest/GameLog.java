package steward.contest;

import java.util.ArrayList;
import java.util.List;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import steward.bot.Burner;
import steward.bot.ErrorLine;
import steward.bot.FaultMessages;
import steward.bot.TimeSpent;
import steward.bot.isolation.ChosenLocale;
import steward.bot.isolation.Isolation;
import steward.bot.isolation.MissingFiles;
import steward.bot.isolation.SandboxLevel;
import steward.contest.Contest.Entrant;
import steward.contest.loss.LeadLog;
import steward.contest.repeat.GameFacts;
import steward.game.Game;
import steward.game.GameJson;
import steward.match.MatchListener;
import steward.match.MatchResult;
import steward.match.Protocol;
import steward.match.Turn;
import steward.replay.TranscriptDigest;
import steward.text.TextFormat;

/**
 * Listener of one game that collects facts which its result does not contain. They are the reasons why bots failed, the
 * last lines that they wrote to stderr, the answer times, and {@link GameFacts}. Its cost per turn is writing the
 * turn's commands.
 */
public final class GameLog implements MatchListener {

    /** Characters of a line of stderr that are kept. */
    private static final int LONGEST = 200;

    private final List<Protocol> protocols;
    private final List<Entrant> entrants;
    private final BooleanSupplier bothProtocols;
    private final Supplier<Isolation> isolation;
    private final String[][] stderr;
    private final int[] asked;
    private final int[] answers;
    private final AnswerTimes[] times;
    private final int[] lastTurn;
    /** Time spent on an answer that the referee counts as late: of one that may be so by chance, if there is. */
    private final TimeSpent[] strikes;
    private final List<Failure> failures = new ArrayList<>();
    private final TranscriptDigest digest = new TranscriptDigest();
    private volatile int turns;
    private Game game;
    private GameJson codec;
    private GameFacts facts;
    /** {@code null} unless it is asked for. */
    private LeadLog leads;

    /** @param rotation by how many places the bots have moved up */
    public GameLog(Contest contest, int rotation) {
        this(entrants(contest, rotation).stream().map(Entrant::protocol).toList(), entrants(contest, rotation),
            contest::hasBothProtocols, contest.staging().isolation());
    }

    private static List<Entrant> entrants(Contest contest, int rotation) {
        return IntStream.range(0, contest.players())
            .mapToObj(player -> contest.entrants().get(contest.entrantOf(player, rotation))).toList();
    }

    /**
     * A log of a game between these players.
     *
     * @param protocols     what each speaks
     * @param entrants      who they are; none if their commands are not of this machine
     * @param bothProtocols whether the scene has both, asked when a bot failed
     * @param isolation     how bots are kept apart, {@code null} if that is not known; asked when a bot failed
     */
    GameLog(List<Protocol> protocols, List<Entrant> entrants, BooleanSupplier bothProtocols,
            Supplier<Isolation> isolation) {
        this.protocols = protocols;
        this.entrants = entrants;
        this.bothProtocols = bothProtocols;
        this.isolation = isolation;
        int players = protocols.size();
        stderr = new String[players][Failure.LINES];
        asked = new int[players];
        answers = new int[players];
        times = new AnswerTimes[players];
        lastTurn = new int[players];
        strikes = new TimeSpent[players];
        for (int player = 0; player < players; player++) {
            times[player] = new AnswerTimes();
        }
    }

    /** Notes from now on who leads. */
    void followLeads() {
        leads = new LeadLog(protocols.size());
    }

    @Override
    public void start(Game startedGame, GameJson startedCodec) {
        game = startedGame;
        codec = startedCodec;
    }

    @Override
    public void commands(Turn turn) {
        digest.commands(turn, codec);
        note(turn);
    }

    /** Notes who failed, and how long answers took. */
    void note(Turn turn) {
        for (int player = 0; player < turn.players(); player++) {
            if (!turn.asked(player)) {
                continue;
            }
            if (asked[player]++ == 0) {
                times[player].addFirst(turn.nanos(player));
            } else {
                times[player].add(turn.nanos(player), turn.number());
            }
            if (turn.stderr(player) != null) {
                remember(player, turn.stderr(player));
            }
            lastTurn[player] = turn.number();
            if (turn.answered(player)) {
                answers[player]++;
                strikes[player] = strikes[player] != null && strikes[player].doubtful() ? strikes[player]
                    : turn.timeSpent(player) == null ? strikes[player] : turn.timeSpent(player);
            } else if (turn.fault(player) != null) {
                failures.add(failure(player, turn));
            }
        }
    }

    @Override
    public void played(Turn turn) {
        turns = turn.number();
        digest.played(game);
        if (leads != null) {
            leads.note(game);
        }
    }

    @Override
    public void end(MatchResult result) {
        for (int player = 0; player < result.players().size(); player++) {
            thrownOut(player, result.players().get(player).fault());
        }
        facts = GameFacts.of(game, digest).behind(leads == null ? List.of() : leads.behindFrom());
    }

    /** Adds a failure of which no turn tells: the referee has thrown the player out. It failed in its last turn. */
    void thrownOut(int player, String reason) {
        if (reason == null || failures.stream().anyMatch(failure -> failure.player() == player)) {
            return;
        }
        List<String> all = lines(stderr[player]);
        failures.add(new Failure(player, lastTurn[player], reason, all.subList(Math.max(0, all.size() - Failure.LINES),
            all.size()).stream().map(line -> TextFormat.beginning(line, LONGEST)).toList(), "", List.of(),
            strikes[player], null));
    }

    /** Keeps the last texts, latest first; they are split into lines only if a bot fails. */
    private void remember(int player, String text) {
        String[] texts = stderr[player];
        System.arraycopy(texts, 0, texts, 1, texts.length - 1);
        texts[0] = text;
    }

    private Failure failure(int player, Turn turn) {
        List<String> all = lines(stderr[player]);
        int found = error(all, turn.stderr(player));
        int error = found < 0 && FaultMessages.isExit(turn.fault(player)) ? all.size() - 1 : found;
        int from = Math.max(0, found < 0 ? all.size() - Failure.LINES : Math.min(all.size() - Failure.LINES, found));
        List<String> lines = all.subList(from, Math.min(all.size(), from + Failure.LINES)).stream()
            .map(line -> TextFormat.beginning(line, LONGEST)).toList();
        int behind = turn.fault(player).indexOf(Failure.RECEIVED);
        String received = turn.answer(player) != null ? turn.answer(player)
            : behind < 0 ? "" : turn.fault(player).substring(behind + Failure.RECEIVED.length());
        Isolation sandbox = isolation.get();
        List<String> hints = new ArrayList<>(FailureHints.of(protocols.get(player), bothProtocols, answers[player],
            turn.fault(player), received, lines, turn.timeSpent(player), sandbox));
        if (answers[player] == 0 && !entrants.isEmpty() && lines.stream().anyMatch(FailureHints::isClassMissing)
            && ChosenLocale.hidesClassesIn(entrants.get(player).program().folder())) {
            hints.add(FailureHints.LOCALE);
        }
        if (answers[player] == 0 && sandbox != null && sandbox.level() == SandboxLevel.STRICT
            && !entrants.isEmpty() && FaultMessages.isExit(turn.fault(player))) {
            MissingFiles.of(entrants.get(player).program(), lines, sandbox).forEach(path ->
                hints.add(FailureHints.missing(path)));
        }
        Burner burner = turn.burner(player);
        if (burner != null) {
            hints.add(FailureHints.beside(entrants.get(burner.player()).name(), burner));
        }
        return new Failure(player, turn.number(), turn.fault(player), lines, error < 0 ? ""
            : TextFormat.beginning(ErrorLine.text(all.get(error)), LONGEST), hints, turn.timeSpent(player), burner);
    }

    /** The lines that are not blank of texts, the latest of which stands first. */
    private static List<String> lines(String... texts) {
        StringBuilder all = new StringBuilder();
        for (int k = texts.length - 1; k >= 0; k--) {
            all.append(texts[k] == null ? "" : texts[k]);
        }
        return all.toString().lines().filter(line -> !line.isBlank()).toList();
    }

    /** The index of the line that says why, or -1; one of an earlier turn only if the bot wrote nothing in its last. */
    private static int error(List<String> all, String now) {
        int before = now == null || now.isBlank() ? 0 : Math.max(0, all.size() - lines(now).size());
        int found = ErrorLine.index(all.subList(before, all.size()));
        return found < 0 ? -1 : before + found;
    }

    /** Returns how many turns have been played; may be asked by any thread. */
    int turns() {
        return turns;
    }

    /** Returns how long answers took, by player; when the game is over. */
    public List<AnswerTimes> times() {
        return List.of(times);
    }

    /** Returns the facts that the result does not contain; nothing is known of a game without a result. */
    public GameFacts facts() {
        return facts == null ? GameFacts.UNKNOWN : facts;
    }

    /** The failures, in the order in which they happened; when the game is over. */
    public List<Failure> failures() {
        return List.copyOf(failures);
    }
}
