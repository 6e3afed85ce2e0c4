package steward.cli;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** Bot programs in shell that speak the text protocol of one pod each, for the scene {@code duel}. */
public final class TextShellBots {

    static final String SCRIPT = """
        #!/bin/sh
        # arguments: drive or stay, the turn in which it answers nonsense (0: never)
        turn=0
        while read -r x y nextX nextY distance angle && read -r otherX otherY; do
          turn=$((turn + 1))
          echo "[PDATA] turns = $turn" >&2
          if [ $turn = 1 ]; then echo "[PDATA+] half = 0.5" >&2; echo "[TDATA][1] x = $x" >&2; fi
          if [ $turn = "$2" ]; then echo nonsense; continue; fi
          if [ "$1" = drive ]; then echo "$nextX $nextY 100"; else echo "$x $y 0"; fi
        done
        """;

    private final Path script;

    /** @param folder the script goes there */
    public TextShellBots(Path folder) {
        ShellBots.assumeRunnable();
        script = folder.resolve("text pod.sh");
        try {
            Files.writeString(script, SCRIPT);
        } catch (IOException problem) {
            throw new UncheckedIOException(problem);
        }
    }

    /** Races. */
    public String driver() {
        return "sh '" + script + "' drive 0";
    }

    /** Never moves, and fails in this turn if it is not 0. */
    public String idler(int fails) {
        return "sh '" + script + "' stay " + fails;
    }
}
