package steward.game.podrace.simulator;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.DoubleSupplier;
import java.util.function.LongSupplier;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import steward.game.podrace.protocol.PodRaceType;
import steward.match.TestScenes;
import steward.numerics.SplitMix64;

/**
 * Time of a turn of {@code steward_podrace.hpp} beside the textbook, the engine of matches and the simulator, in
 * {@link SpeedGames}: {@code gradle headerSpeed -Prounds=20}. All take turns within each round, so that other work on
 * the machine meets them all. The least and the median time of a turn are printed, and the median share in the
 * simulator's time. Rows by degrees are playouts by angles.
 */
public final class HeaderSpeed {

    private static final int PODS = 4;
    /** Times that a program plays the games in a round. */
    private static final String REPETITIONS = "20";
    private static final Path RESOURCES = Path.of("src/test/resources/steward/podrace");
    private static final Path HEADER = Path.of("src/python/include");

    private final Map<String, List<Double>> times = new LinkedHashMap<>();
    private final Path folder = Files.createTempDirectory("header-speed");

    private HeaderSpeed() throws IOException {
    }

    /** @param words {@code --rounds N}: how often each plays */
    public static void main(String[] words) throws Exception {
        new HeaderSpeed().run(words.length > 1 ? Integer.parseInt(words[1]) : 10);
    }

    private void run(int rounds) throws Exception {
        Map<String, Path> programs = new LinkedHashMap<>();
        for (String compiler : List.of("g++", "clang++")) {
            if (CppHeader.isInstalled(compiler)) {
                programs.put(compiler + " -O3 -march=native", compile(compiler, "-O3", "-march=native"));
                programs.put(compiler + " -O2", compile(compiler, "-O2"));
            }
        }
        PodRaceType.PodRaceSetup setup = (PodRaceType.PodRaceSetup) TestScenes.open("mad-pod-racing");
        SpeedGames race = new SpeedGames(setup, false);
        SpeedGames brawl = new SpeedGames(setup, true);
        Map<String, byte[]> games = new LinkedHashMap<>();
        games.put("race", bytes(race.map(), race.commands()));
        games.put("brawl", bytes(brawl.map(), brawl.commands()));
        games.put("by 18 degrees", bytes(race.map(), angles(true)));
        games.put("by any degrees", bytes(race.map(), angles(false)));
        for (int round = 0; round < rounds; round++) {
            for (Map.Entry<String, byte[]> each : games.entrySet()) {
                for (Map.Entry<String, Path> program : programs.entrySet()) {
                    measure(each.getKey() + ", header, " + program.getKey(), () -> play(program.getValue(),
                        each.getValue()));
                }
            }
            measureJava("race, ", race);
            measureJava("brawl, ", brawl);
        }
        System.out.printf("%-48s %8s %8s %13s%n", "ns a turn", "least", "median", "of simulator");
        times.forEach((name, found) -> System.out.printf(Locale.ROOT, "%-48s %8.1f %8.1f %13s%n", name,
            Collections.min(found), median(found.stream().mapToDouble(Double::doubleValue)), share(name, found)));
    }

    private static double median(DoubleStream of) {
        double[] sorted = of.sorted().toArray();
        return sorted[sorted.length / 2];
    }

    /** The median of the rounds' shares in the simulator's time, if it plays these games. */
    private String share(String name, List<Double> found) {
        List<Double> simulator = times.get(name.substring(0, name.indexOf(',')) + ", simulator");
        return simulator == null ? "" : String.format(Locale.ROOT, "%.2f", median(IntStream.range(0, found.size())
            .mapToDouble(round -> found.get(round) / simulator.get(round))));
    }

    private void measureJava(String crowd, SpeedGames games) {
        games.ways().forEach((name, way) -> measure(crowd + name, () -> time(way)));
    }

    private void measure(String name, DoubleSupplier time) {
        times.computeIfAbsent(name, key -> new ArrayList<>()).add(time.getAsDouble());
    }

    /** The least time of a turn of some repetitions, as the programs print it. */
    private static double time(LongSupplier way) {
        double least = Double.POSITIVE_INFINITY;
        for (int k = Integer.parseInt(REPETITIONS); k > 0; k--) {
            long begin = System.nanoTime();
            long turns = way.getAsLong();
            least = Math.min(least, (double) (System.nanoTime() - begin) / turns);
        }
        return least;
    }

    private static double play(Path program, byte[] games) {
        try {
            Process process = new ProcessBuilder(program.toString(), REPETITIONS)
                .redirectError(ProcessBuilder.Redirect.INHERIT).start();
            try (OutputStream out = process.getOutputStream()) {
                out.write(games);
            }
            return Double.parseDouble(new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8)
                .split(" ")[0]);
        } catch (IOException problem) {
            throw new IllegalStateException(problem);
        }
    }

    private Path compile(String compiler, String... flags) throws IOException, InterruptedException {
        Path program = folder.resolve(compiler + String.join("", flags));
        List<String> call = new ArrayList<>(List.of(compiler, "-std=c++17", "-I" + HEADER));
        call.addAll(Arrays.asList(flags));
        call.addAll(List.of(RESOURCES.resolve("speed.cpp").toString(), "-o", program.toString()));
        if (new ProcessBuilder(call).inheritIO().start().waitFor() != 0) {
            throw new IllegalStateException("cannot compile: " + call);
        }
        return program;
    }

    /** Random turns to both sides. */
    private static PodCommands[][] angles(boolean full) {
        SplitMix64 random = new SplitMix64(1);
        PodCommands[][] commands = new PodCommands[SpeedGames.GAMES][SpeedGames.TURNS];
        for (PodCommands[] game : commands) {
            for (int turn = 0; turn < game.length; turn++) {
                game[turn] = new PodCommands(PODS);
                for (int pod = 0; pod < PODS; pod++) {
                    if (turn == 0) {
                        game[turn].set(pod, random.nextInt(16_000), random.nextInt(9_000), 200);
                    } else {
                        game[turn].turn(pod, full ? 36 * random.nextInt(2) - 18 : 36 * random.nextDouble() - 18,
                            random.nextInt(3) == 0 ? random.nextInt(0, 200) : 200);
                    }
                }
            }
        }
        return commands;
    }

    private static byte[] bytes(double[][] map, PodCommands[][] commands) {
        int words = 3 + 2 * map.length + 3 * PODS * commands.length * commands[0].length;
        ByteBuffer out = ByteBuffer.allocate(Long.BYTES * words).order(ByteOrder.LITTLE_ENDIAN);
        out.putLong(map.length);
        for (double[] place : map) {
            out.putDouble(place[0]).putDouble(place[1]);
        }
        out.putLong(commands.length).putLong(commands[0].length);
        for (PodCommands[] game : commands) {
            for (PodCommands each : game) {
                for (int pod = 0; pod < PODS; pod++) {
                    out.putDouble(Double.isNaN(each.targetY(pod)) ? each.degrees(pod) : each.targetX(pod))
                        .putDouble(each.targetY(pod)).putLong(each.thrust(pod));
                }
            }
        }
        return out.array();
    }
}
