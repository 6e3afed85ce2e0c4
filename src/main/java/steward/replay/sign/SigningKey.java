package steward.replay.sign;

import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.KeyFactory;
import java.security.KeyPair;
import java.security.KeyPairGenerator;
import java.security.PrivateKey;
import java.security.SecureRandom;
import java.security.Signature;
import java.security.interfaces.EdECPrivateKey;
import java.security.spec.NamedParameterSpec;
import java.security.spec.PKCS8EncodedKeySpec;
import java.util.Arrays;
import java.util.Base64;
import steward.files.InputException;

/** Private key that signs replays: an Ed25519 key of the JDK, in a file as PKCS#8. Thread-safe. */
public final class SigningKey {

    private static final String PEM = "PRIVATE KEY";

    private final PrivateKey key;
    private final SignerKey publicKey;

    private SigningKey(PrivateKey key, SignerKey publicKey) {
        this.key = key;
        this.publicKey = publicKey;
    }

    /** A new one. */
    public static SigningKey generate() {
        try {
            KeyPair pair = KeyPairGenerator.getInstance(SignerKey.ALGORITHM).generateKeyPair();
            return new SigningKey(pair.getPrivate(), SignerKey.of(pair.getPublic()));
        } catch (GeneralSecurityException problem) {
            throw missing(problem);
        }
    }

    /**
     * Reads a file in PEM.
     *
     * @throws InputException if it cannot be read or holds no such key
     */
    public static SigningKey read(Path file) {
        byte[] encoded = PemFile.read(file, PEM, "a private key for signatures, as steward key makes it");
        try {
            PrivateKey key = KeyFactory.getInstance(SignerKey.ALGORITHM)
                .generatePrivate(new PKCS8EncodedKeySpec(encoded));
            return new SigningKey(key, publicKeyOf(key));
        } catch (GeneralSecurityException problem) {
            throw new InputException(file + ": found a damaged or other kind of key, expected an Ed25519 private key");
        }
    }

    /** True if a file seems to hold a private key. */
    public static boolean isPrivate(Path file) {
        return PemFile.isOf(file, PEM);
    }

    /*
     * PKCS#8 holds the 32-byte seed from which the public key follows, but the JDK has no call that derives it. It does
     * derive it when it generates a pair, whose seed it takes from the given generator of random numbers: here, one
     * that returns these 32 bytes. The check is that the generated private key is the given one.
     */
    private static SignerKey publicKeyOf(PrivateKey key) throws GeneralSecurityException {
        byte[] seed = ((EdECPrivateKey) key).getBytes().orElseThrow(() -> new GeneralSecurityException("no bytes"));
        KeyPairGenerator generator = KeyPairGenerator.getInstance(SignerKey.ALGORITHM);
        generator.initialize(new NamedParameterSpec(SignerKey.ALGORITHM), new Given(seed));
        KeyPair pair = generator.generateKeyPair();
        if (!Arrays.equals(key.getEncoded(), pair.getPrivate().getEncoded())) {
            throw new GeneralSecurityException("this Java makes keys in another way");
        }
        return SignerKey.of(pair.getPublic());
    }

    /** Returns the bytes of a key in place of random ones. */
    private static final class Given extends SecureRandom {

        private final byte[] seed;

        Given(byte[] seed) {
            this.seed = seed;
        }

        @Override
        public void nextBytes(byte[] bytes) {
            System.arraycopy(seed, 0, bytes, 0, Math.min(seed.length, bytes.length));
        }
    }

    /**
     * Writes this key to a file that only its owner can read, and the public one beside it, with {@code .pub} behind
     * the name. Both must be new.
     *
     * @throws InputException if one is there already, or cannot be written
     */
    public void write(Path file) {
        Path beside = publicFile(file);
        PemFile.checkNew(beside);
        PemFile.write(file, PEM, key.getEncoded(), true);
        PemFile.write(beside, SignerKey.PEM, publicKey.encoded(), false);
    }

    /** Returns where the public key of a private one is put. */
    public static Path publicFile(Path file) {
        return file.resolveSibling(file.getFileName() + ".pub");
    }

    public SignerKey publicKey() {
        return publicKey;
    }

    /** The signature of a message, in base64. */
    public String sign(byte[] message) {
        try {
            Signature signature = Signature.getInstance(SignerKey.ALGORITHM);
            signature.initSign(key);
            signature.update(message);
            return Base64.getEncoder().encodeToString(signature.sign());
        } catch (GeneralSecurityException problem) {
            throw missing(problem);
        }
    }

    private static IllegalStateException missing(GeneralSecurityException problem) {
        return new IllegalStateException("this Java cannot sign with Ed25519: " + problem.getMessage(), problem);
    }
}
