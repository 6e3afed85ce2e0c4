package steward.bot.isolation;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;

/** Which variables a bot inherits. */
class BotEnvironmentTest {

    private static final Map<String, String> ALL = Map.of("PATH", "/bin", "HOME", "/home/me", "LC_ALL", "C", "TMPDIR",
        "/var/tmp/me", "PYENV_ROOT", "/home/me/.pyenv", "GITHUB_TOKEN", "a", "client_secret", "b", "DB_PASSWORD_FILE",
        "c",
        "AWS_KEY", "d", "KEYBOARD", "e");

    private static Map<String, String> left(BotEnvironment environment, SandboxLevel level) {
        Map<String, String> variables = new TreeMap<>(ALL);
        environment.apply(variables, level);
        return variables;
    }

    @Test
    void namesThatLookLikeSecretsAreNotInherited() {
        Set<String> kept = Set.of("PATH", "HOME", "LC_ALL", "TMPDIR", "PYENV_ROOT", "KEYBOARD");
        assertEquals(kept, left(BotEnvironment.USUAL, SandboxLevel.OFF).keySet());
        assertEquals(kept, left(BotEnvironment.USUAL, SandboxLevel.LIGHT).keySet());
    }

    @Test
    void theShortListIsThatOfStrictAndOfAWish() {
        Set<String> kept = Set.of("PATH", "HOME", "LC_ALL", "TMPDIR");
        assertEquals(kept, left(BotEnvironment.USUAL, SandboxLevel.STRICT).keySet());
        assertEquals(kept, left(new BotEnvironment(true, List.of()), SandboxLevel.LIGHT).keySet());
        assertEquals("/tmp", left(BotEnvironment.USUAL, SandboxLevel.STRICT).get("TMPDIR"));
    }

    @Test
    void whatIsNamedIsPassedAlsoIfItLooksLikeASecret() {
        BotEnvironment named = new BotEnvironment(false, List.of("GITHUB_TOKEN", "PYENV_ROOT"));
        assertEquals(Set.of("PATH", "HOME", "LC_ALL", "TMPDIR", "PYENV_ROOT", "GITHUB_TOKEN"),
            left(named, SandboxLevel.STRICT).keySet());
        assertEquals(Set.of("PATH", "HOME", "LC_ALL", "TMPDIR", "PYENV_ROOT", "KEYBOARD", "GITHUB_TOKEN"),
            left(named, SandboxLevel.OFF).keySet());
    }
}
