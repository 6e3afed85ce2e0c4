package steward.machines.token;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import steward.league.LeagueFolder;

/**
 * A broker's key for the leagues of all tests in a JVM, made once: a start of the keytool takes most of a second. Tests
 * of the key itself let the program make it.
 */
public final class SharedBrokerKey {

    private static byte[] keys;
    private static String password;

    private SharedBrokerKey() { }

    /** Gives a league the key; before its first worker is added. */
    public static synchronized void put(LeagueFolder league) throws IOException {
        BrokerKey key = new BrokerKey(league);
        Path secret = key.store().resolveSibling("broker.password");
        if (keys == null) {
            key.make();
            keys = Files.readAllBytes(key.store());
            password = Files.readString(secret);
            return;
        }
        PrivateFile.alone(key.store().getParent(), () -> {
            PrivateFile.write(secret, password, false);
            PrivateFile.write(key.store(), keys, false);
            return null;
        });
    }
}
