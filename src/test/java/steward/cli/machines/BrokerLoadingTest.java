package steward.cli.machines;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.File;
import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.cli.Cli;
import steward.cli.FreePort;
import steward.cli.SeveralCalls;
import steward.cli.ShellBots;
import steward.cli.TextShellBots;
import steward.league.LeagueFolder;
import steward.machines.token.SharedBrokerKey;

/**
 * Only {@code worker} and {@code league run --serve} load the broker; all others also run without its files, and would
 * fail if they needed them.
 */
@Tag("process")
@Tag("slow")
@Timeout(300)
@Execution(ExecutionMode.CONCURRENT)
class BrokerLoadingTest {

    private static final String BROKER = "org.apache.activemq";

    @TempDir
    private Path folder;

    /** The class path, with or without the files of the broker and what it needs alone. */
    private static String path(boolean broker) {
        return Stream.of(System.getProperty("java.class.path").split(File.pathSeparator))
            .filter(part -> broker
                || !part.matches(".*/(artemis|netty|slf4j|activemq|jctools|jakarta|commons)[^/]*\\.jar"))
            .map(part -> Path.of(part).toAbsolutePath().toString())
            .reduce((one, other) -> one + File.pathSeparator + other).orElseThrow();
    }

    private String run(int status, boolean broker, Class<?> program, List<String> call)
            throws IOException, InterruptedException {
        Path out = folder.resolve("out.txt");
        Path err = folder.resolve("err.txt");
        List<String> words = new ArrayList<>(List.of(Path.of(System.getProperty("java.home"), "bin", "java").toString(),
            "-XX:TieredStopAtLevel=1", "-XX:+UseSerialGC", "-XX:-UsePerfData",
            "-Xlog:class+load", "--enable-native-access=ALL-UNNAMED", "-cp", path(broker),
            program.getName()));
        words.addAll(call);
        Process process = new ProcessBuilder(words).directory(folder.toFile()).redirectOutput(out.toFile())
            .redirectError(err.toFile()).start();
        assertEquals(status, process.waitFor(), () -> call + ": " + read(err));
        read(err).lines().forEach(line -> assertTrue(line.startsWith("steward: ") || line.startsWith("Try 'steward"),
            () -> call + " prints a line that is not ours: " + line));
        return read(out);
    }

    private static String read(Path file) {
        try {
            return Files.readString(file, StandardCharsets.UTF_8);
        } catch (IOException problem) {
            return problem.toString();
        }
    }

    @SafeVarargs
    @SuppressWarnings("varargs")
    private void loadsNoBroker(List<String>... calls) throws IOException, InterruptedException {
        String said = run(0, false, SeveralCalls.class, SeveralCalls.words(List.of(calls)));
        assertTrue(said.contains("steward.cli.Main"), said);
        for (List<String> call : calls) {
            assertTrue(said.contains(SeveralCalls.line(0, call)), () -> call + ": " + said);
        }
        for (String library : List.of(BROKER, "io.netty", "org.slf4j")) {
            assertFalse(said.contains(library), () -> "the broker is loaded: " + said);
        }
    }

    private void prepare() throws IOException {
        ShellBots.shortDuel(folder, 5);
        new TextShellBots(folder);
        Cli.league(folder, "init", "TMP/served", "--scene", "TMP/short.json").done();
        for (String bot : List.of("a=codingame:sh 'text pod.sh' drive 0", "b=codingame:sh 'text pod.sh' stay 0")) {
            Cli.league(folder, "add", "TMP/served", bot).done();
        }
        SharedBrokerKey.put(new LeagueFolder(folder.resolve("served")));
    }

    @Test
    @Tag("campaign")
    void noOtherCommandLoadsTheBroker() throws IOException, InterruptedException {
        prepare();
        assertTrue(path(true).contains("artemis") && path(true).contains("netty"), "the files are called so");
        assertFalse(path(false).contains("artemis") || path(false).contains("netty"));
        loadsNoBroker(
                List.of("match", "--scene", "short.json", "--bot", "codingame:sh 'text pod.sh' drive 0", "--bot",
                    "codingame:sh 'text pod.sh' stay 0", "--out", "match.jsonl", "--quiet"),
                List.of("replay", "match.jsonl", "--verify", "--quiet"),
                List.of("league", "init", "night", "--scene", "short.json"),
                List.of("league", "add", "night", "a=codingame:sh 'text pod.sh' drive 0"),
                List.of("league", "add", "night", "b=codingame:sh 'text pod.sh' stay 0"),
                List.of("league", "worker", "add", "served", "attic"),
                List.of("league", "run", "night", "--games", "2", "--quiet"),
                List.of("league", "table", "night"),
                List.of("league", "page", "night", "--out", "night.html"));
    }

    /** Commands that do load it, the second also in vain: {@link #noOtherCommandLoadsTheBroker} would see it. */
    @Test
    @Tag("campaign")
    void aWorkerAndAServedLeagueLoadTheBroker() throws IOException, InterruptedException {
        prepare();
        Cli.league(folder, "worker", "add", "TMP/served", "attic", "--out", "TMP/attic.token").done();
        try (ServerSocket taken = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            String address = "127.0.0.1:" + taken.getLocalPort();
            List<String> joining = List.of("worker", "--join", "no-such-host.invalid:1", "--token-file", "attic.token",
                "--sandbox", "off");
            List<String> serving = List.of("league", "run", "served", "--games", "2", "--quiet", "--serve",
                "127.0.0.1:" + FreePort.next());
            List<String> inVain = List.of("league", "run", "served", "--games", "4", "--serve", address);
            String said = run(0, true, SeveralCalls.class, SeveralCalls.words(List.of(joining, serving, inVain)));
            int joined = said.indexOf(SeveralCalls.line(3, joining));
            assertTrue(said.substring(0, Math.max(0, joined)).contains(BROKER), said);
            assertTrue(said.substring(joined).contains(BROKER), "the part of the league, which the worker has not");
            assertTrue(said.contains(SeveralCalls.line(0, serving)), said);
            assertTrue(said.contains(SeveralCalls.line(2, inVain)), said);
            String err = read(folder.resolve("err.txt"));
            assertTrue(err.contains("found an unknown host"), err);
            assertTrue(err.contains("nothing can listen at " + address), err);
        }
    }
}
