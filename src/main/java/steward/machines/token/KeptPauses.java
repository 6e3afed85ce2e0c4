package steward.machines.token;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.DateTimeException;
import java.time.Instant;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import steward.files.InputException;
import steward.league.LeagueFolder;
import steward.scene.json.Block;
import steward.scene.json.JsonTree;
import steward.scene.json.SceneException;

/** Pauses of a league's workers, in the private file {@code machines/pauses.json}: the next run goes on with them. */
public final class KeptPauses {

    private static final int MOST_SECONDS = (int) TimeUnit.DAYS.toSeconds(1);

    private final Path folder;

    /**
     * A pause.
     *
     * @param length in milliseconds, whole seconds
     * @param began  milliseconds since 1970
     */
    public record Pause(long length, long began) { }

    public KeptPauses(LeagueFolder folder) {
        this.folder = WorkerList.folder(folder);
    }

    private Path file() {
        return folder.resolve("pauses.json");
    }

    /** Returns the pauses by worker. @throws InputException if the file is damaged */
    public Map<String, Pause> read() {
        Map<String, Pause> pauses = new TreeMap<>();
        if (Files.notExists(file())) {
            return pauses;
        }
        String source = file().toString();
        try {
            Block block = new Block(source, "", JsonTree.read(PrivateFile.read(file(), "the pauses of workers"), source,
                "pauses of workers"));
            for (Block each : block.blocks("pauses")) {
                pauses.put(WorkerToken.pattern(each, "worker", WorkerList.NAME), new Pause(
                    TimeUnit.SECONDS.toMillis(each.integer("seconds", 1, MOST_SECONDS)), moment(each)));
                each.done();
            }
            block.done();
            return pauses;
        } catch (SceneException problem) {
            throw new InputException(problem.getMessage());
        }
    }

    private static long moment(Block pause) {
        try {
            return Instant.parse(pause.text("since")).toEpochMilli();
        } catch (DateTimeException | ArithmeticException problem) {
            throw pause.error("since", pause.shown("since"), "a moment such as 2026-12-24T22:59:59Z");
        }
    }

    /** Writes the pauses. @throws InputException if they cannot be written */
    public void write(Map<String, Pause> pauses) {
        PrivateFile.alone(folder, () -> {
            PrivateFile.write(file(), pauses.entrySet().stream().map(each -> "  { \"worker\": \"" + each.getKey()
                + "\", \"seconds\": " + TimeUnit.MILLISECONDS.toSeconds(each.getValue().length())
                + ", \"since\": \"" + Instant.ofEpochMilli(each.getValue().began()) + "\" }")
                .collect(Collectors.joining(",\n", "{ \"pauses\": [\n", "\n] }\n")), true);
            return null;
        });
    }
}
