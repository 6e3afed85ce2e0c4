package steward.cli.resident;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.BufferedReader;
import java.io.IOException;
import java.net.StandardProtocolFamily;
import java.net.UnixDomainSocketAddress;
import java.nio.channels.ServerSocketChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.cli.TextShellBots;
import steward.match.TestSize;
import steward.scene.SceneFiles;

/** The compiled clients, {@code steward-referee} and {@code steward-play}, and the residents that they start. */
@Tag("process")
@Tag("slow")
@Execution(ExecutionMode.CONCURRENT)
class ClientTest {

    private static final String REFEREE = "bin/steward-referee";
    private static final long PATIENCE_NANOS = TimeUnit.SECONDS.toNanos(60);

    @TempDir
    private static Path shared;
    /** Installation of the tests that leave its resident as it is: the first of them starts it. */
    private static ClientHome common;

    @TempDir
    private Path folder;
    private ClientHome home;
    private TextShellBots bots;

    @BeforeAll
    static void install() throws IOException, InterruptedException {
        assumeTrue(ClientHome.isPossible(), "there is no C compiler, or this is not Linux");
        common = new ClientHome(shared);
    }

    @BeforeEach
    void takeTheCommonInstallation() throws IOException {
        home = common;
        bots = new TextShellBots(folder);
    }

    @AfterEach
    void endOtherResidents() {
        if (home != common) {
            home.close();
        }
    }

    @AfterAll
    static void endResidents() {
        if (common != null) {
            common.close();
        }
    }

    private void takeAnInstallationOfItsOwn() throws IOException {
        home = common.another(folder);
    }

    private void makeSockets(String mode) throws IOException {
        Files.setPosixFilePermissions(Files.createDirectories(home.sockets()), PosixFilePermissions.fromString(mode));
    }

    private String[] match(String program, String one, long seed, String... more) {
        List<String> words = new ArrayList<>(List.of(program.split(" ")));
        words.addAll(List.of("-p1", one, "-p2", bots.idler(0), "-scene", "duel", "--sandbox", "off", "--no-deadline",
            "-d", "seed=" + seed));
        words.addAll(List.of(more));
        return words.toArray(new String[0]);
    }

    private void await(String what, BooleanSupplier there) throws InterruptedException {
        long end = System.nanoTime() + PATIENCE_NANOS;
        while (!there.getAsBoolean()) {
            assertTrue(System.nanoTime() < end, what);
            Thread.sleep(10);
        }
    }

    private void sameAsProcesses(int matches) throws IOException, InterruptedException {
        Path log = folder.resolve("log");
        for (int seed = 1; seed <= matches; seed++) {
            ClientHome.Said plain = home.call(match("bin/steward referee", bots.driver(), seed, "-l", log.toString()));
            byte[] logged = Files.readAllBytes(log);
            ClientHome.Said resident = home.call(match(REFEREE, bots.driver(), seed, "-l", log.toString()));
            assertEquals(plain, resident, "seed " + seed);
            assertEquals(0, plain.status());
            assertTrue(Arrays.equals(logged, Files.readAllBytes(log)), "log of seed " + seed);
        }
        assertEquals(1, home.residents().size());
    }

    @Test
    @Tag("sized")
    void matchesAreThoseOfProcesses() throws IOException, InterruptedException {
        sameAsProcesses(Integer.getInteger("steward.games", TestSize.of(2, 100)));
    }

    private void killed(int clients) throws IOException, InterruptedException {
        home.call(match(REFEREE, bots.driver(), 1));
        Path slow = Files.writeString(folder.resolve("slow.sh"),
            "while read -r line; do sleep 0.05; echo 0 0 0; done\n");
        Random random = new Random(38);
        for (int k = 0; k < clients; k++) {
            Process client = home.builder(match(REFEREE, "sh " + slow, k)).start();
            Thread.sleep(random.nextInt(k % 2 == 0 ? 20 : 300));
            client.destroyForcibly().waitFor();
        }
        await("bots outlive their client", () -> ClientHome.processes(slow.toString()).isEmpty());
        assertEquals(1, home.residents().size());
        assertEquals(0, home.call(match(REFEREE, bots.driver(), 1)).status());
    }

    @Test
    @Tag("sized")
    void killedClientsLeaveNoBots() throws IOException, InterruptedException {
        killed(TestSize.of(8, 100));
    }

    @Test
    void aSignalEndsTheMatchAndIsTheStatus() throws IOException, InterruptedException {
        Path slow = Files.writeString(folder.resolve("slow.sh"), "while read -r line; do sleep 9; done\n");
        Process client = home.builder(match(REFEREE, "sh " + slow, 1)).start();
        await("a bot", () -> ClientHome.processes(slow.toString()).size() > 1);
        client.toHandle().destroy();                     // the process would close the streams as well
        ClientHome.Said said = ClientHome.end(client);

        assertEquals(new ClientHome.Said("", "", 143), said);
        await("no bot", () -> ClientHome.processes(slow.toString()).isEmpty());
    }

    @Test
    @Tag("campaign")
    void manyClientsAtOnceHaveOneResident() throws IOException, InterruptedException {
        takeAnInstallationOfItsOwn();
        List<Process> clients = new ArrayList<>();
        for (int k = 0; k < 6; k++) {
            clients.add(home.builder(match(REFEREE, bots.driver(), 1)).start());
        }
        for (Process client : clients) {
            assertEquals(new ClientHome.Said("1\n0\n", "", 0), ClientHome.end(client));
        }
        assertEquals(1, home.residents().size());
    }

    @Test
    @Tag("campaign")
    void anotherEnvironmentOrFolderHasAnotherResident() throws IOException, InterruptedException {
        home.call(match(REFEREE, bots.driver(), 1));
        List<ProcessHandle> one = home.residents();
        try {
            ProcessBuilder other = home.builder(match(REFEREE, bots.driver(), 1));
            other.environment().put("STEWARD_OTHER", "1");
            assertEquals(0, ClientHome.end(other.start()).status());
            assertEquals(2, home.residents().size());
            assertEquals(0, ClientHome.end(home.builder(match(REFEREE, bots.driver(), 1)).directory(folder.toFile())
                .start()).status());
            assertEquals(3, home.residents().size());
        } finally {
            home.endAllBut(one);
        }
    }

    @Test
    @Tag("campaign")
    void whereThereAreFourAMatchStartsPlainly() throws IOException, InterruptedException {
        takeAnInstallationOfItsOwn();
        makeSockets("rwx------");
        List<ServerSocketChannel> four = new ArrayList<>();
        for (int k = 0; k < 5; k++) {
            four.add(ServerSocketChannel.open(StandardProtocolFamily.UNIX)
                .bind(UnixDomainSocketAddress.of(home.sockets().resolve("0".repeat(31) + k))));
        }
        four.get(4).close();                             // as of a resident that was killed
        assertEquals("1\n0\n", home.call(match(REFEREE, bots.driver(), 1)).out());
        assertEquals(List.of(), home.residents());
        assertTrue(Files.notExists(home.sockets().resolve("0".repeat(31) + 4)), "the socket that nobody serves");
        for (ServerSocketChannel each : four) {
            each.close();
        }
    }

    @Test
    @Tag("campaign")
    void aFolderThatOthersCanOpenIsNotUsed() throws IOException, InterruptedException {
        takeAnInstallationOfItsOwn();
        makeSockets("rwxr-xr-x");
        assertEquals("1\n0\n", home.call(match(REFEREE, bots.driver(), 1)).out());
        assertEquals(List.of(), home.residents());
    }

    @Test
    @Tag("campaign")
    void aResidentThatIsKilledIsReplaced() throws IOException, InterruptedException {
        takeAnInstallationOfItsOwn();
        Path slow = Files.writeString(folder.resolve("slow.sh"),
            "once='" + folder + "/once'\n[ -e \"$once\" ] || { : >\"$once\"; sleep 3; }\n"
            + "while read -r line; do echo 0 0 0; done\n");
        Process client = home.builder(match(REFEREE, "sh " + slow, 1)).start();
        await("a match", () -> Files.exists(folder.resolve("once")));
        home.close();
        ClientHome.Said said = ClientHome.end(client);

        assertEquals(0, said.status(), said.err());
        assertEquals(List.of(), home.residents(), "the match was played plainly");
        assertEquals(0, home.call(match(REFEREE, bots.driver(), 1)).status());
        assertEquals(1, home.residents().size());
    }

    /** A tool takes a match without scores for a draw. */
    @Test
    @Tag("campaign")
    void aResidentThatIsKilledInTheMatchIsALossForEveryBot() throws IOException, InterruptedException {
        takeAnInstallationOfItsOwn();
        Path slow = Files.writeString(folder.resolve("slow.sh"), "while read -r line; do sleep 9; done\n");
        String[] three = match(REFEREE, "sh " + slow, 1, "-p3", "no-such-bot");
        Arrays.setAll(three, k -> three[k].equals("duel") ? "mean-max" : three[k]);
        Process client = home.builder(three).start();
        client.getErrorStream().read();                  // the warning of the third bot
        home.close();
        ClientHome.Said said = ClientHome.end(client);

        assertEquals("-1\n-1\n-1\n", said.out());
        assertTrue(said.err().endsWith("steward: the resident referee has ended before the match\n"), said.err());
        assertEquals(1, said.status());
    }

    /** As the launcher does: a shell writes the environment in an order of its own, and a wrong PWD anew. */
    @Test
    @Tag("campaign")
    void aResidentThatAShellHasStartedIsFound() throws IOException, InterruptedException {
        takeAnInstallationOfItsOwn();
        List<String> words = new ArrayList<>(List.of("sh", "-c", "exec \"$@\"", "sh"));
        words.addAll(home.builder("lib/steward-resident", "resident", "--idle", "60s").command());
        ProcessBuilder shell = home.builder("lib").command(words);
        ProcessBuilder client = home.builder(match(REFEREE, bots.driver(), 1));
        shell.environment().put("PWD", "/");
        client.environment().put("PWD", "/");
        Process resident = shell.start();
        resident.inputReader(StandardCharsets.UTF_8).readLine();
        assertEquals(0, ClientHome.end(client.start()).status());
        assertEquals(List.of(resident.pid()), home.residents().stream().map(ProcessHandle::pid).toList());
    }

    @Test
    void aClosedStreamIsNotTakenForAFile() throws IOException, InterruptedException {
        for (String closed : List.of("<&-", ">&-", "2>&-")) {
            List<String> words = new ArrayList<>(List.of("sh", "-c", "exec \"$@\" " + closed, "sh"));
            words.addAll(home.builder(match(REFEREE, bots.driver(), 1)).command());
            ProcessBuilder shell = home.builder("bin").command(words);
            ClientHome.Said said = ClientHome.end(shell.start());
            assertEquals(closed.equals(">&-") ? new ClientHome.Said("", "steward: cannot write the output: Bad file "
                + "descriptor\n", 1) : new ClientHome.Said("1\n0\n", "", 0), said, closed);
        }
        assertEquals(1, home.residents().size());
    }

    @Test
    void inputGoesThrough() throws IOException, InterruptedException {
        Path scene = Files.writeString(folder.resolve("scene.json"), SceneFiles.load("duel").text());
        Process client = home.builder(REFEREE, "-scene", "-", "-p1", bots.driver(), "-p2", bots.driver(),
            "--no-deadline", "--sandbox", "off").redirectInput(scene.toFile()).start();
        ClientHome.Said said = ClientHome.end(client);
        assertEquals(List.of(0, 3L), List.of(said.status(), said.out().lines().count()), said.toString());
        assertEquals(1, home.residents().size());
    }

    @Test
    void anOutputThatCannotBeWrittenIsSaid() throws IOException, InterruptedException {
        Process client = home.builder(match(REFEREE, bots.driver(), 1))
            .redirectOutput(Path.of("/dev/full").toFile()).start();
        String err = ClientHome.end(client).err();

        assertEquals("steward: cannot write the output: No space left on device\n", err);
        assertEquals(1, client.exitValue());
    }

    @Test
    void aRunningResidentIsFoundWithItsFolderAndMemory() throws IOException, InterruptedException {
        home.call(match(REFEREE, bots.driver(), 1));
        long pid = home.residents().get(0).pid();
        RunningResident found = RunningResident.all().stream().filter(each -> each.pid() == pid).findFirst()
            .orElseThrow();

        assertEquals(Path.of("").toRealPath().toString(), found.folder());
        assertTrue(found.megabytes() > 20, found.toString());
    }

    @Test
    void playAndRefusalsAreThoseOfTheCommand() throws IOException, InterruptedException {
        assertEquals(home.call("bin/steward", "play", "--no"), home.call("bin/steward-play", "--no"));
        assertEquals(2, home.call("bin/steward-play", "--no").status());
    }

    @Test
    @Tag("campaign")
    void aResidentThatIsIdleEnds() throws IOException, InterruptedException {
        takeAnInstallationOfItsOwn();
        Process resident = home.builder("lib/steward-resident", "resident", "--idle", "2s").start();
        BufferedReader in = resident.inputReader(StandardCharsets.UTF_8);
        String line = in.readLine();
        assertTrue(line.endsWith(" and ends when it was idle for 2s"), line);
        ClientHome.Said second = home.call("lib/steward-resident", "resident");
        assertEquals("steward: found a resident for this folder and environment already, process "
            + resident.pid() + "\n", second.err());
        assertTrue(resident.waitFor(60, TimeUnit.SECONDS));
        assertEquals(0, resident.exitValue());
        assertTrue(RunningResident.all().stream().noneMatch(each -> each.pid() == resident.pid()));
        try (var sockets = Files.list(home.sockets())) {
            assertEquals(List.of(), sockets.filter(each -> !each.endsWith("lock")).toList());
        }
    }
}
