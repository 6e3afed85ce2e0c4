package steward.cli.resident;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import steward.bot.command.ProgramFinder;
import steward.cli.Main;

/** An installation of the compiled clients around the classes of the tests; sockets are in a folder of its own. */
final class ClientHome implements AutoCloseable {

    private static final long PATIENCE_S = 120;

    private final Path home;
    private final Path runtime;

    /** Output of a call, and its status. */
    record Said(String out, String err, int status) {
    }

    /** Compiles the client, and installs it. */
    ClientHome(Path folder) throws IOException, InterruptedException {
        this(folder, compiled(folder.resolve("client")));
    }

    private ClientHome(Path folder, Path client) throws IOException {
        home = folder.resolve("home");
        Files.createDirectories(home.resolve("bin"));
        Files.createDirectories(home.resolve("lib"));
        runtime = Files.createDirectory(folder.resolve("run"),
            PosixFilePermissions.asFileAttribute(PosixFilePermissions.fromString("rwx------")));
        Path launcher = Files.writeString(home.resolve("bin/steward"), "#!/bin/sh\nexec '"
            + Path.of(System.getProperty("java.home"), "bin", "java") + "' -XX:TieredStopAtLevel=1 -XX:+UseSerialGC "
            + "-XX:-UsePerfData -Xshare:auto -cp '" + System.getProperty("java.class.path") + "' "
            + Main.class.getName() + " \"$@\"\n");
        assertTrue(launcher.toFile().setExecutable(true));
        for (String name : List.of("bin/steward-referee", "bin/steward-play", "lib/steward-resident")) {
            Files.copy(client, home.resolve(name));
        }
    }

    private static Path compiled(Path client) throws IOException, InterruptedException {
        Process compiler = new ProcessBuilder("cc", "-O2", "-Wall", "-Wextra", "-Werror", "-o", client.toString(),
            "src/launcher/client.c").inheritIO().start();
        assertEquals(0, compiler.waitFor());
        return client;
    }

    /** Another installation, whose sockets are its own. */
    ClientHome another(Path folder) throws IOException {
        return new ClientHome(folder, home.resolve("bin/steward-referee"));
    }

    /** True where the clients can be compiled and find what they need. */
    static boolean isPossible() {
        return ProgramFinder.find("cc") != null && Files.isReadable(Path.of("/proc/self/oom_score_adj"));
    }

    Path sockets() {
        return runtime.resolve("steward-resident");
    }

    /** A call that is still to be started; the first word is a file of the installation. */
    ProcessBuilder builder(String... words) {
        List<String> command = new ArrayList<>(List.of(words));
        command.set(0, home.resolve(words[0]).toString());
        ProcessBuilder builder = new ProcessBuilder(command);
        builder.environment().put("XDG_RUNTIME_DIR", runtime.toString());
        return builder;
    }

    Said call(String... words) throws IOException, InterruptedException {
        return end(builder(words).start());
    }

    static Said end(Process process) throws IOException, InterruptedException {
        process.getOutputStream().close();
        String out = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        String err = new String(process.getErrorStream().readAllBytes(), StandardCharsets.UTF_8);
        assertTrue(process.waitFor(PATIENCE_S, TimeUnit.SECONDS));
        return new Said(out, err, process.exitValue());
    }

    /** The residents that are there. */
    List<ProcessHandle> residents() {
        return processes(sockets() + "/");
    }

    /** Processes with a text in one of their words. */
    static List<ProcessHandle> processes(String text) {
        return ProcessHandle.allProcesses().filter(each -> commandLine(each).contains(text)).toList();
    }

    private static String commandLine(ProcessHandle process) {
        try {
            return Files.readString(Path.of("/proc/" + process.pid() + "/cmdline"),
                StandardCharsets.ISO_8859_1);
        } catch (IOException gone) {
            return "";
        }
    }

    /** Kills the residents that are there, without some of them. */
    void endAllBut(List<ProcessHandle> kept) {
        for (ProcessHandle resident : residents()) {
            if (!kept.contains(resident)) {
                resident.destroyForcibly();
                resident.onExit().orTimeout(PATIENCE_S, TimeUnit.SECONDS).join();
            }
        }
    }

    @Override
    public void close() {
        endAllBut(List.of());
    }
}
