package steward.cli.check;

import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.TimeUnit;
import steward.bot.FaultMessages;
import steward.bot.TimeBasis;
import steward.bot.UnstartablePlayer;
import steward.cli.shared.Games;
import steward.contest.Contest;
import steward.contest.Failure;
import steward.contest.GameLog;
import steward.match.MatchResult;
import steward.match.Protocol;
import steward.match.TimeControl;
import steward.text.TextFormat;

/**
 * Check of one bot by a whole game against the weakest bundled bot and a game against players that never answer. If the
 * bot is late, or nearly, it is tried again, at last without charging it for the processor time of other programs.
 *
 * @param contest with the bot as its only entrant
 * @param games   as far as they were played; the second is not after a failure in the first
 */
public record BotCheck(Contest contest, List<Tried> games) {

    private static final long SEED = 1;
    /** An answer that takes more of its limit is late on a machine that is a little slower. */
    private static final double EDGE = 0.8;
    /** Most times that a game is begun anew in which a bundled bot was late. */
    private static final int MOST_SPOILT = 3;
    /** In place of the slowest answer, where it was not charged for a busy machine. */
    private static final long UNSTARVED = -1;

    /**
     * A game.
     *
     * @param against whom
     * @param result  or {@code null} if there is none
     * @param failure of the bot, or {@code null}
     * @param worst   the slowest answer after the first, in nanoseconds; -1 if it was in time without what other
     *                programs used
     * @param turns   what it was sent and answered
     */
    public record Tried(String against, MatchResult result, Failure failure, long worst,
                        List<CheckDialogue.Turn> turns) { }

    /**
     * Tries a bot.
     *
     * @param empty what is played, without bots
     * @param bot   that can be started
     */
    public static BotCheck of(Contest empty, Contest.Entrant bot) throws InterruptedException {
        List<Tried> games = new ArrayList<>();
        int others = empty.players() - 1;
        String weakest = Games.weakestBot(empty.setup().scene().gameId());
        games.add(others == 0 ? tried(empty, bot, "alone", List.of(), false)
            : weakest == null ? tried(empty, bot, "itself", Collections.nCopies(others, bot), false)
            : tried(empty, bot, weakest, Collections.nCopies(others, Contest.entrant("builtin:" + weakest,
                Protocol.JSON)), false));
        if (others > 0 && games.get(0).failure() == null) {
            games.add(tried(empty, bot, "silence", Collections.nCopies(others, bot), true));
        }
        return new BotCheck(empty.between(List.of(bot)), games);
    }

    private static Tried tried(Contest empty, Contest.Entrant bot, String against, List<Contest.Entrant> others,
                               boolean silent) throws InterruptedException {
        Tried found = play(empty, bot, against, others, silent);
        for (int k = 0; k < MOST_SPOILT && !silent && isSpoilt(found, others, bot); k++) {
            found = play(empty, bot, against, others, silent);
        }
        boolean byCpu = empty.time().basis() == TimeBasis.CPU;
        if (!isLate(empty, bot, found) || bot.words().isEmpty() || byCpu && found.failure() != null) {
            return found;
        }
        found = byCpu ? found : play(empty, bot, against, others, silent);
        if (!isLate(empty, bot, found)) {
            return found;
        }
        TimeControl time = empty.time();
        double share = found.failure() == null ? EDGE : 1;
        Tried own = play(empty.limitedBy(new TimeControl(time.firstNanos(), (long) (share * time.turnNanos()),
            byCpu ? TimeBasis.CPU : TimeBasis.UNSTARVED, share * time.factor())), bot, against, others, silent);
        return own.failure() == null ? new Tried(against, own.result(), null, UNSTARVED, own.turns())
            : found.failure() == null ? found : own;
    }

    /** True if a bundled bot was late: then it is no whole game. */
    private static boolean isSpoilt(Tried tried, List<Contest.Entrant> others, Contest.Entrant bot) {
        return tried.failure() == null && tried.result() != null && !others.contains(bot)
            && tried.result().players().stream().skip(1).anyMatch(player -> player.fault() != null);
    }

    /** True if it was late, or so near to it that it would be on a slower machine. */
    private static boolean isLate(Contest contest, Contest.Entrant bot, Tried tried) {
        return tried.failure() != null ? FaultMessages.isTime(tried.failure().reason())
            : limit(contest, bot, 1) != Long.MAX_VALUE && tried.worst() > EDGE * limit(contest, bot, 1);
    }

    private static Tried play(Contest empty, Contest.Entrant bot, String against, List<Contest.Entrant> others,
                              boolean silent) throws InterruptedException {
        List<Contest.Entrant> all = new ArrayList<>(List.of(bot));
        for (int k = 0; k < others.size(); k++) {
            all.add(others.get(k).named(against + (others.size() > 1 ? "-" + (k + 1) : "")));
        }
        List<CheckDialogue> dialog = new ArrayList<>();
        Contest contest = empty.between(all).startedBy((entrant, isolation, rest) -> {
            if (entrant != bot) {
                return silent ? new UnstartablePlayer(entrant.name(), "it is silent")
                    : empty.staging().starter().player(entrant, isolation, rest);
            }
            dialog.add(new CheckDialogue(empty.staging().starter().player(entrant, isolation, rest)));
            return dialog.get(0);
        });
        GameLog log = new GameLog(contest, 0);
        MatchResult result = null;
        try {
            result = contest.play(SEED, 0, null, log);
        } catch (UncheckedIOException problem) {
            result = null;
        }
        Failure failure = log.failures().stream().filter(each -> each.player() == 0).findFirst().orElse(null);
        return new Tried(against, result, failure, log.times().get(0).worstNanos(),
            dialog.isEmpty() ? List.of() : dialog.get(0).turns());
    }

    /** True if nothing is wrong. */
    public boolean passes() {
        return problems().isEmpty();
    }

    public Contest.Entrant bot() {
        return contest.entrants().get(0);
    }

    /** The failure, or {@code null} if it did not fail. */
    public Failure failure() {
        return games.stream().map(Tried::failure).filter(each -> each != null).findFirst().orElse(null);
    }

    /** Faults that were found, each with what to do. */
    public List<String> problems() {
        List<String> problems = new ArrayList<>();
        Failure failure = failure();
        if (failure != null) {
            problems.add(Advice.of(failure, contest));
        }
        if (games.stream().anyMatch(game -> game.result() == null)) {
            problems.add("a game has no result");
        }
        int early = games.stream().filter(game -> game.result() != null)
            .mapToInt(game -> game.result().players().get(0).earlyTurns()).sum();
        if (early > 0 && failure == null) {
            problems.add("it wrote more lines than it was asked for, in " + TextFormat.count(early, "turn") + ": they "
                + "are taken for later answers. " + Advice.DEBUGGING);
        }
        long limit = limit(1);
        if (failure == null && limit != Long.MAX_VALUE && worst() > EDGE * limit) {
            problems.add("its slowest answer took " + ms(worst()) + " of " + ms(limit) + ": on a busy or slower "
                + "machine it will be late. Leave a fifth of the limit");
        }
        return problems;
    }

    /** A referee of the scene's own says its limits as it asks: none is known here. */
    private long limit(int answers) {
        return limit(contest, bot(), answers);
    }

    private static long limit(Contest contest, Contest.Entrant bot, int answers) {
        return contest.setup().isGuest() && bot.limits() == null ? Long.MAX_VALUE
            : contest.time().limit(contest.limits(List.of(bot)).get(0), 0, answers);
    }

    /** Without the first answer, which has a limit of its own. */
    private long worst() {
        return games.stream().mapToLong(Tried::worst).max().orElse(0);
    }

    private static String ms(long nanos) {
        return TextFormat.number(nanos / TextFormat.NANOS_PER_MS, 1) + " ms";
    }

    /** The steps in order, with what they came to. */
    public List<String> steps() {
        List<String> steps = new ArrayList<>();
        Tried first = games.get(0);
        boolean starts = first.failure() == null || first.failure().turn() > 1;
        long took = first.turns().isEmpty() ? 0 : first.turns().get(0).nanos();
        steps.add(step(starts, "starts and answers", starts ? "the first answer took " + ms(took) + limit(took, 0)
            : "failed in turn 1"));
        for (Tried game : games) {
            steps.add(step(game.failure() == null && game.result() != null, game.against().equals("alone")
                ? "plays a whole game" : "plays against " + game.against(), end(game)));
        }
        if (failure() == null && limit(1) != Long.MAX_VALUE) {
            steps.add(step(worst() <= EDGE * limit(1), "keeps the limit with room", games.stream().anyMatch(game ->
                game.worst() == UNSTARVED) ? "without waiting for processors that other programs used"
                : "the slowest later answer took " + ms(worst()) + limit(worst(), 1)));
        }
        return steps;
    }

    private String limit(long took, int answers) {
        long limit = limit(answers);
        return limit == Long.MAX_VALUE || took < 0 ? "" : " of " + TimeUnit.NANOSECONDS.toMillis(limit) + " ms";
    }

    private static String end(Tried game) {
        if (game.failure() != null) {
            return "failed in turn " + game.failure().turn();
        }
        return game.result() == null ? "no result" : TextFormat.count(game.result().turns(), "turn") + ", "
            + game.result().ending();
    }

    private static String step(boolean good, String what, String detail) {
        return "  " + TextFormat.left(good ? "yes" : "no", 5) + TextFormat.left(what, 28) + detail;
    }
}
