package steward.machines.token;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.KeyStore;
import java.util.List;
import steward.league.LeagueFolder;

/**
 * A broker's key for the leagues of all tests in a JVM, made once: a start of the keytool takes most of a second. Its
 * store is derived from the password in one step, not in ten thousand, as each test opens it some times. Tests of the
 * key itself let the program make it.
 */
public final class SharedBrokerKey {

    private static final List<String> STEPS = List.of("keystore.pkcs12.macIterationCount",
        "keystore.pkcs12.certPbeIterationCount", "keystore.pkcs12.keyPbeIterationCount");

    private static byte[] keys;
    private static String password;

    private SharedBrokerKey() { }

    /** Gives a league the key; before its first worker is added. */
    public static synchronized void put(LeagueFolder league) throws IOException {
        BrokerKey key = new BrokerKey(league);
        Path secret = key.store().resolveSibling("broker.password");
        if (keys == null) {
            key.make();
            password = Files.readString(secret);
            keys = quick(key);
        }
        PrivateFile.alone(key.store().getParent(), () -> {
            PrivateFile.write(secret, password, true);
            PrivateFile.write(key.store(), keys, true);
            return null;
        });
    }

    private static byte[] quick(BrokerKey key) throws IOException {
        STEPS.forEach(steps -> System.setProperty(steps, "1"));
        try (InputStream in = Files.newInputStream(key.store())) {
            char[] own = key.password().toCharArray();
            KeyStore made = KeyStore.getInstance("PKCS12");
            made.load(in, own);
            String alias = made.aliases().nextElement();
            KeyStore store = KeyStore.getInstance("PKCS12");        // one that was loaded keeps its number of steps
            store.load(null, null);
            store.setKeyEntry(alias, made.getKey(alias, own), own, made.getCertificateChain(alias));
            ByteArrayOutputStream bytes = new ByteArrayOutputStream();
            store.store(bytes, own);
            return bytes.toByteArray();
        } catch (GeneralSecurityException problem) {
            throw new IOException(problem);
        } finally {
            STEPS.forEach(System::clearProperty);
        }
    }
}
