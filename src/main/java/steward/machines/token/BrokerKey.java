package steward.machines.token;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.KeyStore;
import java.security.PublicKey;
import java.security.SecureRandom;
import java.security.cert.Certificate;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.concurrent.TimeUnit;
import steward.files.InputException;
import steward.files.Sha256;
import steward.league.LeagueFolder;

/**
 * Private key and self-signed certificate of a league's broker. Workers know the key by its fingerprint, SHA-256 over
 * the encoded public key (X.509 SubjectPublicKeyInfo), so that the certificate can be renewed under the same key. The
 * JDK's {@code keytool} makes both.
 */
public final class BrokerKey {

    /** The password that stores of earlier versions were locked with; it stood in our sources. */
    private static final char[] FORMER = "steward".toCharArray();
    private static final int PASSWORD_BYTES = 32;
    private static final String ALIAS = "broker";
    private static final String DAYS = "3650";
    private static final long PATIENCE_S = 60;

    private final Path store;
    private final Path secret;

    /** The key of a league; it need not be there. */
    public BrokerKey(LeagueFolder folder) {
        store = WorkerList.folder(folder).resolve("broker.p12");
        secret = store.resolveSibling("broker.password");
    }

    /** The store of keys, of type PKCS12. */
    public Path store() {
        return store;
    }

    /** The password of the store, from a file of the owner's alone. */
    public String password() {
        return PrivateFile.read(secret, "the password of " + store.getFileName()).strip();
    }

    /** Makes a key and a certificate, if they are not there; locks a store of an earlier version anew. */
    public void make() {
        PrivateFile.alone(store.getParent(), () -> {
            if (Files.exists(store)) {
                lockAnew();
            } else {
                makePassword();
                generate();
                PrivateFile.close(store);
            }
            return store;
        });
    }

    private void makePassword() {
        if (!Files.exists(secret)) {
            byte[] random = new byte[PASSWORD_BYTES];
            new SecureRandom().nextBytes(random);
            PrivateFile.write(secret, HexFormat.of().formatHex(random) + "\n", false);
        }
    }

    /** Gives a store with the former password one of its own; key, certificate and so all tokens are kept. */
    private void lockAnew() {
        try {
            KeyStore keys = KeyStore.getInstance("PKCS12");
            try (InputStream in = Files.newInputStream(store)) {
                keys.load(in, FORMER);
            } catch (IOException locked) {
                if (!Files.exists(secret)) {
                    throw new InputException(secret + ": found no such file, expected the password of "
                        + store.getFileName() + "; without both a new key is made, and workers need new tokens");
                }
                return;
            }
            makePassword();
            char[] own = password().toCharArray();
            keys.setKeyEntry(ALIAS, keys.getKey(ALIAS, FORMER), own, keys.getCertificateChain(ALIAS));
            ByteArrayOutputStream bytes = new ByteArrayOutputStream();
            keys.store(bytes, own);
            PrivateFile.write(store, bytes.toByteArray(), true);
        } catch (IOException | GeneralSecurityException problem) {
            throw new InputException(store + ": cannot be read: " + problem.getMessage());
        }
    }

    private void generate() {
        keytool(List.of("-genkeypair", "-alias", ALIAS, "-keyalg", "EC", "-groupname", "secp256r1", "-sigalg",
            "SHA256withECDSA", "-dname", "CN=steward league", "-validity", DAYS, "-keystore", store.toString(),
            "-storetype", "PKCS12"));
    }

    /** Makes a new certificate for the same key: workers go on trusting it. */
    public void renew() {
        Path request = store.resolveSibling("broker.csr");
        Path certificate = store.resolveSibling("broker.crt");
        try {
            keytool(List.of("-certreq", "-alias", ALIAS, "-keystore", store.toString(), "-file", request.toString()));
            keytool(List.of("-gencert", "-alias", ALIAS, "-keystore", store.toString(), "-validity", DAYS, "-infile",
                request.toString(), "-outfile", certificate.toString()));
            keytool(List.of("-importcert", "-noprompt", "-alias", ALIAS, "-keystore", store.toString(), "-file",
                certificate.toString()));
        } finally {
            request.toFile().delete();
            certificate.toFile().delete();
        }
    }

    private void keytool(List<String> options) {
        List<String> words = new ArrayList<>();
        words.add(Path.of(System.getProperty("java.home"), "bin", "keytool").toString());
        words.add("-J-XX:TieredStopAtLevel=1");          // twice as fast for the short time that it runs
        words.addAll(options);
        words.addAll(List.of("-storepass:file", secret.toString()));
        try {
            Process process = new ProcessBuilder(words).redirectErrorStream(true).start();
            process.getOutputStream().close();
            String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8).strip();
            if (!process.waitFor(PATIENCE_S, TimeUnit.SECONDS) || process.exitValue() != 0) {
                process.destroyForcibly();
                throw new InputException("keytool " + options.get(0) + " failed: " + said.replace('\n', ' '));
            }
        } catch (IOException problem) {
            throw new InputException("found no program " + words.get(0) + ", expected the keytool of Java: "
                + problem.getMessage());
        } catch (InterruptedException interrupted) {
            Thread.currentThread().interrupt();
            throw new InputException("keytool was interrupted");
        }
    }

    /** The certificate as it is now. */
    Certificate certificate() {
        try (InputStream in = Files.newInputStream(store)) {
            KeyStore keys = KeyStore.getInstance("PKCS12");
            keys.load(in, password().toCharArray());
            Certificate certificate = keys.getCertificate(ALIAS);
            if (certificate == null) {
                throw new InputException(store + ": found no key '" + ALIAS + "', expected the broker's");
            }
            return certificate;
        } catch (IOException | GeneralSecurityException problem) {
            throw new InputException(store + ": cannot be read: " + problem.getMessage());
        }
    }

    public String fingerprint() {
        return fingerprint(certificate().getPublicKey());
    }

    /** The fingerprint of any key: 64 hexadecimal digits. */
    public static String fingerprint(PublicKey key) {
        return Sha256.hex(key.getEncoded());
    }
}
