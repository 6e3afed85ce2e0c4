package steward.bot.isolation;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Message about a level that does not work: the program's own words, and the cause only where it is one. */
class FailedTrialTest {

    private static final String CONTAINER = "this is a container that does not let programs make namespaces";

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
        sandbox: namespaces: Operation not permitted                                  | 125
        sandbox: /proc: Operation not permitted                                       | 125
        sandbox: /proc: Permission denied                                             | 125
        unshare: unshare failed: Operation not permitted                              | 1
        unshare: mount /proc failed: Permission denied                                | 1
        bwrap: No permissions to create new namespace, likely because of the kernel   | 1
        bwrap: Creating new namespace failed: Operation not permitted                 | 1
        bwrap: Can't mount proc on /newroot/proc: Operation not permitted             | 1
        """)
    void whatAContainerForbidsIsSaidOfIt(String line, int status) {
        assertEquals(CONTAINER + " (" + line + ")", new FailedTrial(false, false, true).reason(line, status));
        assertEquals(line, new FailedTrial(false, false, false).reason(line, status));
        assertEquals("user namespaces are switched off on this machine (" + line + ")",
            new FailedTrial(true, true, true).reason(line, status));
        assertEquals("AppArmor does not let programs make user namespaces (" + line + ")",
            new FailedTrial(false, true, true).reason(line, status));
    }

    /** It was said of every failure in a container. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
        sandbox: fork: Resource temporarily unavailable        | 125
        sandbox: limit: Invalid argument                       | 125
        sandbox: namespaces: Invalid argument                  | 125
        sandbox: /bin/sh: Permission denied                    | 126
        /proc/self/exe: Permission denied                      | 126
        did not end within 10000 ms                            | -1
        setpriv: capabilities: Invalid argument                | 1
        bwrap: Can't find source path /x: No such file         | 1
        """)
    void anotherFailureIsToldInItsOwnWords(String line, int status) {
        assertEquals(line, new FailedTrial(true, true, true).reason(line, status));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
        sandbox: namespaces: No space left on device           | user namespaces are switched off on this machine
        sandbox: limit: No space left on device                |
        """)
    void aMachineWithoutNamespacesSaysThatNoMoreFit(String line, String cause) {
        assertEquals(cause == null ? line : cause + " (" + line + ")",
            new FailedTrial(true, false, true).reason(line, 125));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
        setpriv: unrecognized option '--x' | 1   | setpriv: unrecognized option '--x'; it is too old
        ''                                 | 139 | status 139
        """)
    void anOldProgramAndASilentOne(String line, int status, String reason) {
        assertEquals(reason, new FailedTrial(false, false, true).reason(line, status));
    }
}
