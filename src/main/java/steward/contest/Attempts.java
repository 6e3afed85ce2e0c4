package steward.contest;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import steward.bot.TimeBasis;
import steward.contest.Contest.Entrant;

/**
 * Attempts at one game that may be lost on time through no fault of the bot. Decides whether the game is played again
 * and whether the last attempt counts. Further attempts have the same seed:
 *
 * <ul>
 * <li>If the bot may have been late only because it waited for a processor ({@link Failure#doubtful}), the game is
 * played again without charging the bot for waiting ({@link TimeBasis#UNSTARVED}).
 * <li>If limits are of CPU time, the game is played again if the bot waited for half of its time
 * ({@link Failure#starved}).
 * <li>If another bot computed meanwhile and was not yet held, the game is played again once with that bot held from the
 * start. If that bot cannot be held, the game is played twice more.
 * <li>If another bot computes or the machine is too busy in each of {@value #MOST} attempts, the game is discarded.
 * </ul>
 *
 * <p>With {@link Hiccups#COUNT} every first attempt counts.
 */
public final class Attempts {

    /** How often a game may be played. */
    public static final int MOST = 3;

    private final Contest contest;
    private final Hiccups hiccups;
    private final int rotation;
    private final Set<Entrant> held = new LinkedHashSet<>();
    private int played;
    private boolean unstarved;
    private String discarded;

    /** @param rotation by how many places the bots have moved up */
    public Attempts(Contest contest, Hiccups hiccups, int rotation) {
        this.contest = contest;
        this.hiccups = hiccups;
        this.rotation = rotation;
    }

    /** Contest of the next attempt, with bots held that have burned, and without charging them for the machine. */
    public Contest contest() {
        Contest next = held.isEmpty() ? contest : contest.holding(held);
        return unstarved ? next.limitedBy(TimeBasis.UNSTARVED) : next;
    }

    /** Number of attempts so far. */
    public int played() {
        return played;
    }

    /**
     * Adds an attempt with a result.
     *
     * @param failures of its bots
     * @return whether the game is to be played again
     */
    public boolean demandAnother(List<Failure> failures) {
        played++;
        List<Failure> beside = failures.stream().filter(failure -> failure.burner() != null).toList();
        if (hiccups == Hiccups.COUNT) {
            return false;
        }
        if (beside.isEmpty()) {
            boolean wall = contest.time().basis() == TimeBasis.WALL;
            return doubtful(failures.stream().filter(wall ? Failure::doubtful : Failure::starved).findFirst()
                .orElse(null));
        }
        if (beside.stream().allMatch(failure -> failure.burner().holdable())) {
            return held.addAll(beside.stream().map(failure -> entrant(failure.burner().player())).toList())
                && played < MOST;
        }
        if (played == MOST) {
            discarded = reason(beside.get(0));
        }
        return played < MOST;
    }

    private Entrant entrant(int player) {
        return contest.entrants().get(contest.entrantOf(player, rotation));
    }

    private String reason(Failure failure) {
        return String.format(Locale.ROOT, "not counted: %s computed on %.2f processors while %s was asked, in each of"
            + " %d attempts, and cannot be held here", entrant(failure.burner().player()).name(),
            failure.burner().processors(), entrant(failure.player()).name(), MOST);
    }

    private boolean doubtful(Failure failure) {
        if (failure == null) {
            return false;
        }
        unstarved = contest.time().basis() == TimeBasis.WALL;
        if (played == MOST) {
            discarded = "not counted: " + entrant(failure.player()).name() + " waited for a processor that other "
                + "programs used, in each of " + MOST + " attempts";
        }
        return played < MOST;
    }

    /** Returns why the last attempt does not count although it has a result, or {@code null}. */
    public String discarded() {
        return discarded;
    }
}
