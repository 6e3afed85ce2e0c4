package steward.replay.verify;

import steward.game.GameTypes;
import steward.game.ViewWriter;
import steward.replay.ReplayException;
import steward.replay.ReplayReader;

/**
 * Result of playing a recorded match again and comparing every line.
 *
 * @param turns      how many turns agreed
 * @param states     in how many of these the full state was recorded, and so compared; of an imported match, in how
 *                   many a server has shown it
 * @param whole      whether there is a result, and it agrees
 * @param difference the first difference, or {@code null} if there is none
 * @param warning    where the file was cut off, or {@code null}
 * @param olderLaw   by which law the match was played, where that is older than the one of its rung and nothing was
 *                   compared; otherwise {@code null}
 * @param signature  what its signature is worth; {@code CUT_OFF} wherever it was not reached
 */
public record Verification(int turns, int states, boolean whole, ReplayDifference difference, String warning,
                           String olderLaw, SignatureCheck signature) {

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
     * Verifies a replay as {@link #of(ReplayReader, GameTypes)} does.
     *
     * @param views counts what is compared of an import's frames, for one verification; or {@code null}
     */
    public static Verification of(ReplayReader replay, GameTypes types, ViewComparison views) {
        if (replay.header() == null) {
            return uncompared(replay, null);
        }
        if (replay.importedEarlier()) {
            throw new ReplayException(replay.source() + ":1: imported: found an import of an earlier version, expected "
                + "one of this version: 'steward import' makes it anew from the recording");
        }
        try {
            ViewWriter writer = !replay.imported() ? null : types.viewWriter(replay.header().game()).orElse(null);
            Resimulation again = new Resimulation(replay.header(), null, types, replay.source(), writer);
            try {
                return new LineCheck(replay, again, writer == null ? null
                    : (views == null ? new ViewComparison() : views).of(writer, again.game())).verify();
            } finally {
                again.game().close();
            }
        } catch (OlderLawException older) {
            return uncompared(replay, older.laws());
        }
    }

    private static Verification uncompared(ReplayReader replay, String olderLaw) {
        return new Verification(0, 0, false, null, replay.warning(), olderLaw,
            SignatureCheck.UNSIGNED);
    }
}
