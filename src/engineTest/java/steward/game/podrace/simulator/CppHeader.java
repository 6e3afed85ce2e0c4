package steward.game.podrace.simulator;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.BufferedOutputStream;
import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.TestReporter;
import steward.game.podrace.PodState;
import steward.game.podrace.Races;
import steward.game.podrace.RulesEdition;

/**
 * The header {@code steward_podrace.hpp}, compiled in several ways with each compiler that is there. Every turn that is
 * given here is played by all of the programs, which compare each number with the one expected, bit by bit.
 */
public final class CppHeader implements AutoCloseable {

    /** Turns left that are not compared: those of a player who is out. */
    public static final int NOT_COMPARED = -1000;

    private static final int PODS = 4;
    private static final List<String> USUAL = List.of("-O2");
    private static final List<List<String>> FLAGS = List.of(USUAL, List.of("-O0"), List.of("-O3", "-march=native"),
        List.of("-O2", "-DSTEWARD_SCALAR"));
    private static final int LARGEST_RECORD = 1 << 14;
    static final Path HEADER = Path.of("src/python/include/steward_podrace.hpp");
    private static final Path SOURCE = Path.of("src/test/resources/steward/podrace/compare.cpp");
    /** As an author of a contest begins a file. */
    private static final String OFAST = "#pragma GCC optimize(\"Ofast\")\n#pragma GCC target(\"avx2,fma\")\n";

    private final ByteBuffer record = ByteBuffer.allocate(LARGEST_RECORD).order(ByteOrder.LITTLE_ENDIAN);
    private final List<Path> programs;
    private final List<Process> running = new ArrayList<>();
    private final List<OutputStream> inputs = new ArrayList<>();
    private final TestReporter report;
    private long turns;

    /** Programs by the usual flags, compiled once for all tests. */
    private static final class Usual {
        static final List<Path> PROGRAMS = programs(List.of(USUAL), false);
    }

    /** Programs by all flags, and by some under {@link #OFAST}. */
    private static final class Every {
        static final List<Path> PROGRAMS = programs(FLAGS, true);
    }

    /**
     * Starts the programs; the test is skipped, saying so, where there is no compiler.
     *
     * @param everyFlag whether compiled by all flags, for campaigns, or by {@code -O2} alone
     */
    public CppHeader(TestReporter report, boolean everyFlag) {
        this.report = report;
        programs = everyFlag ? Every.PROGRAMS : Usual.PROGRAMS;
        assumeTrue(!programs.isEmpty(), "skipped: there is neither g++ nor clang++");
        try {
            for (Path program : programs) {
                Process process = new ProcessBuilder(program.toString()).redirectErrorStream(true).start();
                running.add(process);
                inputs.add(new BufferedOutputStream(process.getOutputStream(), 1 << 16));
            }
        } catch (IOException problem) {
            throw new UncheckedIOException(problem);
        }
    }

    /** @param underOfast true if compiled as a file under {@link #OFAST} too */
    private static List<Path> programs(List<List<String>> everyFlags, boolean underOfast) {
        try {
            Path folder = Files.createTempDirectory("steward-header");
            Files.copy(HEADER, folder.resolve(HEADER.getFileName()));
            Path plain = Files.copy(SOURCE, folder.resolve("plain.cpp"));
            Path ofast = Files.writeString(folder.resolve("ofast.cpp"), OFAST + Files.readString(SOURCE));
            List<List<String>> calls = new ArrayList<>();
            for (String compiler : List.of("g++", "clang++")) {
                if (isInstalled(compiler)) {
                    everyFlags.forEach(flags -> calls.add(call(compiler, flags, plain)));
                }
            }
            if (underOfast && isInstalled("g++") && hasAvx2()) {
                everyFlags.stream().limit(2).forEach(flags -> calls.add(call("g++", flags, ofast)));
            }
            List<Path> programs = IntStream.range(0, calls.size()).parallel()
                .mapToObj(k -> compile(folder, calls.get(k))).toList();
            Runtime.getRuntime().addShutdownHook(new Thread(() -> delete(folder)));
            return programs;
        } catch (IOException problem) {
            throw new UncheckedIOException(problem);
        }
    }

    private static List<String> call(String compiler, List<String> flags, Path source) {
        List<String> call = new ArrayList<>(List.of(compiler, "-std=c++17", "-Wall", "-Wextra", "-Werror"));
        call.addAll(flags);
        call.add(source.toString());
        return call;
    }

    static boolean isInstalled(String program) {
        return Stream.of(System.getenv("PATH").split(File.pathSeparator))
            .anyMatch(folder -> Files.isExecutable(Path.of(folder, program)));
    }

    static boolean hasAvx2() throws IOException {
        Path processor = Path.of("/proc/cpuinfo");
        return Files.isReadable(processor) && Files.readString(processor).contains(" avx2");
    }

    /** Compiles without any warning. */
    private static Path compile(Path folder, List<String> call) {
        String name = String.join("", call).replaceAll("[^a-zA-Z0-9]", "").replace("Wall", "");
        Path program = folder.resolve(name.substring(0, Math.min(100, name.length())) + call.hashCode());
        List<String> words = new ArrayList<>(call);
        words.addAll(List.of("-o", program.toString()));
        try {
            Process process = new ProcessBuilder(words).redirectErrorStream(true).start();
            String said = text(process.getInputStream());
            assertEquals(0, process.waitFor(), String.join(" ", words) + "\n" + said);
            return program;
        } catch (IOException problem) {
            throw new UncheckedIOException(problem);
        } catch (InterruptedException problem) {
            throw new IllegalStateException(problem);
        }
    }

    private static String text(InputStream in) throws IOException {
        return new String(in.readAllBytes(), StandardCharsets.UTF_8);
    }

    private static void delete(Path folder) {
        try (var files = Files.list(folder)) {
            for (Path file : files.toList()) {
                Files.delete(file);
            }
            Files.delete(folder);
        } catch (IOException problem) {
            throw new UncheckedIOException(problem);
        }
    }

    /** True if the header takes a coordinate or speed. */
    static boolean fits(double... numbers) {
        return Arrays.stream(numbers).map(Math::abs).allMatch(size -> size == 0 || size >= 0x1p-100 && size <= 0x1p30);
    }

    /** True if the header takes these targets; the engine plays the speeds that others lead to in another way. */
    static boolean fits(PodCommands commands) {
        return IntStream.range(0, PODS).allMatch(pod -> isTarget(commands.targetX(pod))
            && isTarget(commands.targetY(pod)));
    }

    private static boolean isTarget(double value) {
        double size = Math.abs(value);
        return size == 0 || size >= 0x1p-300 && size <= 0x1p300;
    }

    /** Begins to play on another map. */
    public void map(double[][] map, RulesEdition rules) {
        record.putLong(1).putLong(rules == RulesEdition.CONTEST ? 1 : 0).putLong(map.length);
        for (double[] place : map) {
            record.putDouble(place[0]).putDouble(place[1]);
        }
        send();
    }

    /** Sets a state. */
    public void state(PodState[] pods, int... turnsLeft) {
        record.putLong(2);
        for (PodState pod : pods) {
            put(pod);
        }
        record.putLong(turnsLeft[0]).putLong(turnsLeft[1]);
        send();
    }

    /** Sets the state of a simulator. */
    public void state(PodRaceSimulator race) {
        state(pods(race), race.turnsLeft(0), race.turnsLeft(1));
    }

    private void put(PodState pod) {
        record.putDouble(pod.x()).putDouble(pod.y()).putDouble(pod.vx()).putDouble(pod.vy()).putDouble(pod.heading())
            .putLong(pod.shieldTimer()).putLong(pod.boostLeft() ? 1 : 0).putLong(pod.passed());
    }

    /** Plays a turn, which has to end in the state of the simulator. */
    public void turn(PodCommands commands, PodRaceSimulator after, int checkpoints) {
        turn(commands, pods(after), checkpoints, new int[] {after.turnsLeft(0), after.turnsLeft(1)}, -1, 0);
    }

    /** Plays a turn, which has to end in this state with this hash; with turn -1 the hash is not compared. */
    public void turn(PodCommands commands, PodState[] after, int checkpoints, int[] turnsLeft, int turn, long hash) {
        record.putLong(3);
        for (int pod = 0; pod < PODS; pod++) {
            boolean byAngle = Double.isNaN(commands.targetY(pod));
            record.putDouble(byAngle ? commands.degrees(pod) : commands.targetX(pod)).putDouble(commands.targetY(pod))
                .putLong(commands.thrust(pod));
        }
        for (PodState pod : after) {
            put(pod);
            record.putLong((pod.passed() + 1) % checkpoints);
        }
        record.putLong(turnsLeft[0]).putLong(turnsLeft[1]).putLong(turn).putLong(hash);
        turns++;
        send();
    }

    private static PodState[] pods(PodRaceSimulator race) {
        return IntStream.range(0, PODS).mapToObj(pod -> Races.state(race, pod)).toArray(PodState[]::new);
    }

    private void send() {
        try {
            for (OutputStream input : inputs) {
                input.write(record.array(), 0, record.position());
            }
        } catch (IOException problem) {
            throw new UncheckedIOException("a program has ended early: " + said(), problem);
        }
        record.clear();
    }

    private List<String> said() {
        List<String> said = new ArrayList<>();
        for (Process process : running) {
            if (!process.isAlive()) {
                try {
                    said.add(text(process.getInputStream()));
                } catch (IOException problem) {
                    said.add(problem.toString());
                }
            }
        }
        return said;
    }

    /** Ends the programs. Each must have played every turn, without a difference. */
    public void assertNothingDiffers() throws IOException, InterruptedException {
        for (int k = 0; k < running.size(); k++) {
            inputs.get(k).close();
            String said = text(running.get(k).getInputStream()).strip();
            String name = programs.get(k).getFileName().toString();
            report.publishEntry(name + ": " + said);
            assertEquals(0, running.get(k).waitFor(), name + ": " + said);
            assertEquals(turns, Long.parseLong(said.split(" ")[0]), name + ": " + said);
        }
    }

    @Override
    public void close() {
        running.forEach(Process::destroy);
    }
}
