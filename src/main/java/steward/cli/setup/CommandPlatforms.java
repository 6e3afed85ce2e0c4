package steward.cli.setup;

import java.util.List;
import steward.bot.command.Platform;

/** Systems on which each command works: rows of {@code docs/platforms.md}, and an item of {@code steward doctor}. */
final class CommandPlatforms {

    /** Needs of a command, which decide where it works. */
    enum Need {
        /** Nothing else. */
        JAVA("Java alone", "as on Linux", "as on Linux"),
        /** Starts bots or JVMs. */
        BOTS("starts bots", "without a sandbox and `--time cpu`", "without a sandbox, `--time cpu` and process groups"),
        /** Runs programs that come with POSIX systems. */
        POSIX("a POSIX shell", "as on Linux", "does not work"),
        /** Asks the system who is at the other end of a socket, and with which limits. */
        LINUX_ONLY("a Unix socket, `/proc`", "does not work: `steward-play` and `steward-referee` start plainly",
            "does not work");

        private final String uses;
        private final String macos;
        private final String windows;

        Need(String uses, String macos, String windows) {
            this.uses = uses;
            this.macos = macos;
            this.windows = windows;
        }
    }

    private static final String LINUX = "linux";

    private CommandPlatforms() { }

    /** @throws IllegalArgumentException if nothing is said of the command */
    static Need of(String command) {
        return switch (command) {
            case "run", "replay", "scene", "explain", "simulate", "import", "key", "stability", "tradeoff", "new",
                "doctor", "help" -> Need.JAVA;
            case "match", "feed", "demo", "league", "worker", "sprt", "tune", "check", "tournament", "referee", "play",
                "adopt" -> Need.BOTS;
            case "bench", "completion" -> Need.POSIX;
            case "resident" -> Need.LINUX_ONLY;
            default -> throw new IllegalArgumentException("no platforms are told for " + command);
        };
    }

    /** The table of all commands in Markdown. */
    static String table(List<String> commands) {
        StringBuilder table = new StringBuilder(
            "| command | uses | Linux, WSL 2 | macOS, *untried* | Windows, *untried* |\n|---|---|---|---|---|\n");
        for (String command : commands) {
            Need need = of(command);
            table.append("| `").append(command).append("` | ").append(need.uses).append(" | works | ")
                .append(need.macos).append(" | ").append(need.windows).append(" |\n");
        }
        return table.toString();
    }

    /** An item about the platform of this machine. */
    static Checkup.Item item(String platform) {
        boolean tried = platform.startsWith(LINUX);
        return new Checkup.Item("java", "platform", tried, platform + (tried ? ": every command is tried on Linux"
            : ": untried; what should work of each command is in docs/platforms.md"));
    }

    static Checkup.Item item() {
        return item(Platform.here());
    }
}
