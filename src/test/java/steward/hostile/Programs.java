package steward.hostile;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import steward.bot.command.ProgramFinder;

/** The programs of {@code src/test/hostile}, in folders of their own: a bot sees its folder at every level. */
final class Programs {

    private static final Path SOURCES = Path.of("src/test/hostile");

    private final Path attacker;
    private final Path honest;
    private final boolean compiled;

    /** @param folder where they are put */
    Programs(Path folder) {
        try {
            attacker = Files.createDirectories(folder.resolve("attacker"));
            honest = Files.createDirectories(folder.resolve("opponent"));
            Files.copy(SOURCES.resolve("hostile.sh"), attacker.resolve("hostile.sh"));
            Files.copy(SOURCES.resolve("honest.sh"), honest.resolve("honest.sh"));
            compiled = compile();
        } catch (IOException problem) {
            throw new UncheckedIOException(problem);
        } catch (InterruptedException broken) {
            throw new IllegalStateException(broken);
        }
    }

    private boolean compile() throws IOException, InterruptedException {
        if (ProgramFinder.find("cc") == null) {
            return false;
        }
        return new ProcessBuilder("cc", "-O1", "-pthread", "-o", attacker.resolve("hostile").toString(),
            SOURCES.resolve("hostile.c").toString()).inheritIO().start().waitFor() == 0;
    }

    /** True if the program of an attack is there. */
    boolean has(Attack attack) {
        return !attack.program().equals("c") || compiled;
    }

    /** The command of a hostile bot whose processes carry a mark. */
    String command(Attack attack, String mark) throws IOException {
        String program = attack.program().equals("c") ? attacker.resolve("hostile").toString()
            : "sh " + attacker.resolve("hostile.sh");
        return program + " " + attack.word() + " " + mark + " "
            + Files.readSymbolicLink(Path.of("/proc/self/ns/pid"));
    }

    /** The command of the opponent. */
    String honest(String mark) {
        return "sh " + honest.resolve("honest.sh") + " " + mark;
    }
}
