package steward.replay.sign;

import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.KeyFactory;
import java.security.PublicKey;
import java.security.Signature;
import java.security.spec.X509EncodedKeySpec;
import java.util.Arrays;
import java.util.Base64;
import steward.files.InputException;
import steward.files.Sha256;

/** Public key of a replay's signer: an Ed25519 key of the JDK, in X.509 form. */
public final class SignerKey {

    static final String ALGORITHM = "Ed25519";
    static final String PEM = "PUBLIC KEY";
    private static final int SIGNATURE_BYTES = 64;

    private final PublicKey key;
    private final byte[] encoded;

    private SignerKey(PublicKey key, byte[] encoded) {
        this.key = key;
        this.encoded = encoded;
    }

    static SignerKey of(PublicKey key) {
        return new SignerKey(key, key.getEncoded());
    }

    /**
     * Reads a file in PEM.
     *
     * @throws InputException if it cannot be read or holds no such key
     */
    public static SignerKey read(Path file) {
        try {
            return decode(PemFile.read(file, PEM, "a public key for signatures, as steward key writes to FILE.pub"));
        } catch (GeneralSecurityException problem) {
            throw new InputException(file + ": found a damaged or other kind of key, expected an Ed25519 public key");
        }
    }

    /**
     * The key that a replay names.
     *
     * @throws IllegalArgumentException if the text is none, or spelled in another way than {@link #text}
     */
    public static SignerKey ofText(String text) {
        try {
            SignerKey key = decode(Base64.getDecoder().decode(text));
            if (key.text().equals(text)) {
                return key;
            }
        } catch (GeneralSecurityException | IllegalArgumentException problem) {
            // Reported below, like a text that is not base64.
        }
        throw new IllegalArgumentException("no Ed25519 public key in base64");
    }

    private static SignerKey decode(byte[] encoded) throws GeneralSecurityException {
        PublicKey key = KeyFactory.getInstance(ALGORITHM).generatePublic(new X509EncodedKeySpec(encoded));
        if (!Arrays.equals(key.getEncoded(), encoded)) {
            throw new GeneralSecurityException("another spelling of a key");
        }
        return of(key);
    }

    /** The key as one word: X.509 in base64, as between the lines of its file. */
    public String text() {
        return Base64.getEncoder().encodeToString(encoded);
    }

    /** The fingerprint, for people to compare: {@code SHA256:} and the hash of the key in base64. */
    public String fingerprint() {
        return "SHA256:" + Base64.getEncoder().withoutPadding().encodeToString(Sha256.of(encoded));
    }

    /** True if the signature, in base64, is that of the message by the owner of this key. */
    public boolean verifies(byte[] message, String signature) {
        try {
            byte[] bytes = Base64.getDecoder().decode(signature);
            if (bytes.length != SIGNATURE_BYTES || !Base64.getEncoder().encodeToString(bytes).equals(signature)) {
                return false;
            }
            Signature check = Signature.getInstance(ALGORITHM);
            check.initVerify(key);
            check.update(message);
            return check.verify(bytes);
        } catch (IllegalArgumentException | GeneralSecurityException problem) {
            return false;
        }
    }

    byte[] encoded() {
        return encoded.clone();
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof SignerKey signer && Arrays.equals(encoded, signer.encoded);
    }

    @Override
    public int hashCode() {
        return Arrays.hashCode(encoded);
    }

    @Override
    public String toString() {
        return fingerprint();
    }
}
