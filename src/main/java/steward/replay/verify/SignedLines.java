package steward.replay.verify;

import steward.replay.ReplayReader;
import steward.replay.sign.LinesDigest;
import steward.replay.sign.SignerKey;

/** Digest of the lines of a replay that names its signer, and check of the signature. */
final class SignedLines {

    private final ReplayReader replay;
    private final SignerKey signer;
    private final LinesDigest digest;

    SignedLines(ReplayReader replay) {
        this.replay = replay;
        String key = replay.header().signer();
        signer = key == null ? null : SignerKey.ofText(key);
        digest = key == null ? null : new LinesDigest();
    }

    /** Adds a line, without {@code times} and the closing brace. */
    void add(byte[] line, int length) {
        if (digest != null) {
            digest.add(line, length);
        }
    }

    /** @param whole whether all lines up to the result were added */
    SignatureCheck check(boolean whole) {
        if (signer == null) {
            return SignatureCheck.UNSIGNED;
        }
        if (!whole || replay.warning() != null) {
            return new SignatureCheck(SignatureCheck.Verdict.CUT_OFF, signer);
        }
        String signature = replay.signature();
        boolean right = signature != null && signer.verifies(digest.message(replay.isolation()), signature);
        return right ? new SignatureCheck(SignatureCheck.Verdict.RIGHT, signer, replay.isolation())
            : new SignatureCheck(SignatureCheck.Verdict.WRONG, signer);
    }
}
