package steward.replay.verify;

import steward.replay.sign.SignerKey;

/**
 * Result of checking a replay's signature.
 *
 * @param signer    the key that the header names, or {@code null} if it names none
 * @param isolation how bots were kept apart, where the signer has signed that; the level is its first word
 */
public record SignatureCheck(Verdict verdict, SignerKey signer, String isolation) {

    /** A replay that names no signer. */
    public static final SignatureCheck UNSIGNED = new SignatureCheck(Verdict.UNSIGNED, null);

    /** A check of which it is not known how bots were kept apart. */
    public SignatureCheck(Verdict verdict, SignerKey signer) {
        this(verdict, signer, null);
    }

    /** Result of the check. */
    public enum Verdict {
        /** The replay names no signer. */
        UNSIGNED,
        /** It names one, but was cut off before the signature. */
        CUT_OFF,
        /** Not one byte outside {@code times} differs from what the owner of the key has signed. */
        RIGHT,
        /** The signature is not of this key, or not of these lines. */
        WRONG
    }

    /** True if the owner of this very key has signed. */
    public boolean isBy(SignerKey key) {
        return verdict == Verdict.RIGHT && signer.equals(key);
    }
}
