package steward.live;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Names by which a request may call a server on port 8123 that was told to listen on "Racing.example". */
class AllowedHostsTest {

    private final AllowedHosts names = new AllowedHosts("Racing.example", 8123);

    @ParameterizedTest
    @ValueSource(strings = {"localhost:8123", "LOCALHOST:8123", "127.0.0.1:8123", "[::1]:8123", "192.168.7.1:8123",
        "[fe80::1]:8123", "racing.example:8123"})
    void takesOurNameAndNumericAddresses(String host) {
        assertTrue(names.accept(host));
    }

    @ParameterizedTest
    @ValueSource(strings = {"evil.example:8123", "localhost", "localhost:80", "127.0.0.1",
        "localhost.evil.example:8123", "127.0.0.1.evil.example:8123", "", ":8123", "localhost:8123:8123", "localhost:x",
        "localhost:99999", "[evil.example]:8123", "1.2.3:8123", "evil@localhost:8123"})
    void refusesOthers(String host) {
        assertFalse(names.accept(host));
    }

    @Test
    void refusesARequestWithoutAName() {
        assertFalse(names.accept(null));
    }

    @Test
    void theUsualPortNeedNotBeSaid() {
        assertTrue(new AllowedHosts("localhost", 80).accept("localhost"));
    }
}
