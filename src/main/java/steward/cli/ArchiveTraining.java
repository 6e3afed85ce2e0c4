package steward.cli;

import java.nio.file.Path;
import java.util.List;
import steward.cli.shared.ExitStatus;
import steward.cli.streams.Streams;

/**
 * Run of typical commands, one after the other, to record the classes they load in an archive that makes later starts
 * faster. The launcher calls it; it exits with the status of the first command that fails.
 */
final class ArchiveTraining {

    private static final String RACER = "builtin:racer";
    private static final String PATIENT = "--time-factor=100";

    /** @param arguments a folder for what the commands write */
    public static void main(String[] arguments) {
        Path folder = Path.of(arguments[0]);
        for (List<String> command : List.of(
                List.of("demo", "--out", folder.resolve("demo.jsonl").toString()),
                List.of("match", "--bot", RACER, "--bot", RACER, "--seed=1", PATIENT, "--json", "--out",
                    folder.resolve("match.jsonl").toString()),
                List.of("referee", "-p1", RACER, "-p2", RACER, "-d", "seed=1", PATIENT, "-l",
                    folder.resolve("game.json").toString()),
                List.of("play", "--json-league", RACER, RACER, "--seed=1", PATIENT))) {
            int status = Main.run(Streams.standard(), command.toArray(new String[0]));
            if (status != ExitStatus.DONE) {
                System.exit(status);
            }
        }
    }
}
