package steward.replay.verify;

import steward.game.Game;
import steward.game.GameTypes;
import steward.replay.OutcomeJson;
import steward.replay.RecordedTurn;
import steward.replay.ReplayException;
import steward.replay.ReplayReader;

/**
 * The result of playing a recorded match again and comparing every line.
 *
 * @param turns      how many turns agreed
 * @param states     in how many of these the full state was recorded, and so compared; of an imported match, in how
 *                   many a server has shown it
 * @param whole      whether there is a result, and it agrees
 * @param difference the first difference, or {@code null} if there is none
 * @param warning    where the file was cut off, or {@code null}
 * @param views      what the server's own texts of an imported match are worth: how much of them was compared
 * @param olderLaw   by which law the match was played, where that is older than the one of its rung and nothing was
 *                   compared; otherwise {@code null}
 * @param signature  what its signature is worth; {@code CUT_OFF} wherever it was not reached
 */
public record Verification(int turns, int states, boolean whole, Difference difference, String warning,
                           ViewCounts views, String olderLaw, SignatureCheck signature) {

    /** True if everything recorded agrees, even if the replay was cut off; false if the header is incomplete. */
    public boolean agrees() {
        return difference == null && olderLaw == null && signature.verdict() != SignatureCheck.Verdict.WRONG;
    }

    /** True if everything agrees up to a result, states were compared, and the signature is right if one is due. */
    public boolean verified() {
        return agrees() && whole && states > 0 && signature.verdict() != SignatureCheck.Verdict.CUT_OFF;
    }

    /**
     * Verifies a replay from its first turn to its end or cut.
     *
     * @param replay just opened
     * @throws ReplayException              if the file is damaged before its end
     * @throws steward.scene.json.SceneException if its scene cannot be played
     */
    public static Verification of(ReplayReader replay, GameTypes types) {
        return of(replay, types, null);
    }

    /**
     * Verifies a replay as {@link #of(ReplayReader, GameTypes)} does, and counts questions.
     *
     * @param asked counts in how many turns each player was asked, one element a player; or {@code null}
     * @throws ReplayException as above; also if there are not as many players
     */
    public static Verification of(ReplayReader replay, GameTypes types, int[] asked) {
        if (replay.header() == null) {
            return uncompared(replay, null);
        }
        if (replay.importedEarlier()) {
            throw new ReplayException(replay.source() + ":1: imported: found an import of an earlier version, expected "
                + "one of this version: 'steward import' makes it anew from the recording");
        }
        try {
            Resimulation again = new Resimulation(replay.header(), null, types, replay.source(),
                !replay.imported() ? null : types.viewWriter(replay.header().game()).orElse(null));
            try {
                return of(replay, again, asked);
            } finally {
                again.game().close();
            }
        } catch (OlderLawException older) {
            return uncompared(replay, older.laws());
        }
    }

    private static Verification uncompared(ReplayReader replay, String olderLaw) {
        return new Verification(0, 0, false, null, replay.warning(), ViewCounts.NONE, olderLaw,
            SignatureCheck.UNSIGNED);
    }

    private static Verification of(ReplayReader replay, Resimulation again, int... asked) {
        if (asked != null && asked.length != again.game().players()) {
            throw new ReplayException(replay.source() + ":1: players: found " + again.game().players() + ", expected "
                + asked.length);
        }
        SignedLines signed = new SignedLines(replay);
        LineCheck check = new LineCheck(replay, again, signed);
        Difference difference = check.header();
        String[] faults = new String[again.game().players()];
        int turns = 0;
        int states = 0;
        boolean[] in = new boolean[faults.length];
        boolean whole = false;
        while (difference == null && !whole) {
            byte[] line = replay.nextLine();
            ask(again.game(), in);
            if (line != null && check.isSame(line)) {
                count(in, null, asked);
                states += OutcomeJson.hasState(again.game()) ? 1 : 0;
                replay.passed(++turns);
                continue;
            }
            RecordedTurn turn = replay.turn(line);
            if (turn == null && replay.result() == null) {
                break;
            }
            count(in, turn, asked);
            difference = turn == null ? check.result(faults) : check.turn(line, turn);
            whole = turn == null && difference == null;
            if (turn != null && difference == null) {
                turns += isServers(check) ? 1 : 0;
                states += !replay.imported() && OutcomeJson.hasState(again.game()) ? 1 : 0;
                for (int player = 0; player < faults.length; player++) {
                    faults[player] = faults[player] == null ? turn.faults()[player] : faults[player];
                }
            }
        }
        ViewComparison views = check.views();
        return views == null ? new Verification(turns, states, whole, difference, replay.warning(), ViewCounts.NONE,
            null, signed.check(whole))
            : new Verification(turns, views.turns(), whole, views.difference() != null ? views.difference()
                : difference, replay.warning(), views.counts(), null, signed.check(whole));
    }

    /** False from the turn on in which a server has shown something else. */
    private static boolean isServers(LineCheck check) {
        return check.views() == null || check.views().difference() == null;
    }

    /** Marks who is in before the next turn, if there is one. */
    private static void ask(Game game, boolean... in) {
        for (int player = 0; player < in.length; player++) {
            in[player] = !game.isOver() && game.isAsked(player);
        }
    }

    /** @param turn {@code null} if all who were in answered */
    private static void count(boolean[] in, RecordedTurn turn, int... asked) {
        for (int player = 0; asked != null && player < asked.length; player++) {
            asked[player] += in[player] && (turn == null || turn.asked(player)) ? 1 : 0;
        }
    }
}
