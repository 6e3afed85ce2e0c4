package steward.machines.serve;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import steward.bot.TimeBasis;
import steward.bot.command.ProgramFinder;
import steward.bot.hold.HoldPolicy;
import steward.cli.Cli;
import steward.cli.shared.ExitStatus;
import steward.cli.shared.Games;
import steward.contest.Hiccups;
import steward.guest.StandInProject;
import steward.league.LeagueBot;
import steward.league.LeagueFolder;
import steward.machines.broker.LeagueBroker;
import steward.machines.bundle.Bundle;
import steward.machines.token.BrokerKey;
import steward.machines.token.WorkerList;
import steward.machines.token.WorkerToken;
import steward.machines.wire.HeaderText;
import steward.machines.wire.LeagueWord;
import steward.machines.wire.WireMessage;
import steward.machines.wire.WorkerWord;
import steward.machines.worker.Worker;

/** A league whose scene has a referee of its own, which goes to workers that take it, and to no others. */
@Tag("process")
@Tag("slow")
@Timeout(300)
class GuestWorkerTest extends ServedLeague {

    @AfterEach
    void end() {
        StandInProject.end();
    }

    /** A scene with a stand-in: the mode of the program, or a class path. */
    private void scene(String mode) throws IOException {
        if (mode.equals("classes")) {
            Files.writeString(folder.resolve("short.json"), StandInProject.compiled(folder).scene(2,
                ", \"leagueLevel\": 2"));
            return;
        }
        assumeTrue(ProgramFinder.find("python3") != null, "skipped: there is no python3");
        Path program = Files.copy(Path.of("src/test/resources/referees/standin.py"), folder.resolve("standin.py"));
        Files.writeString(folder.resolve("short.json"), """
            {"name": "small", "game": "guest", "players": 2, "referee": {"command": ["python3", "%s", "%s"]}}"""
            .formatted(program, mode));
    }

    private void league(String name) throws IOException {
        done("init", "TMP/" + name, "--scene", "TMP/short.json", "--seed", "5", "--keep", "all",
            "--time-factor", "20");
        done("add", "TMP/" + name, StandInProject.bot(folder, "one", "1"));
        done("add", "TMP/" + name, StandInProject.bot(folder, "two", "2"));
    }

    private Cli join(String token, String... more) {
        return Cli.run(List.of("worker", "--join", "127.0.0.1:" + port, "--token-file",
            folder.resolve(token + ".token").toString(), "--sandbox", "off", "--idle", "60s", "--bundles",
            folder.resolve("bundles of " + token).toString()), more);
    }

    /** The replays by their files, without what was measured and where bots and referee were. */
    private Map<String, String> replays(String league) throws IOException {
        Map<String, String> texts = new TreeMap<>();
        try (Stream<Path> files = Files.walk(folder.resolve(league).resolve("replays"))) {
            for (Path file : files.filter(Files::isRegularFile).toList()) {
                texts.put(file.getFileName().toString(), Files.readString(file)
                    .replaceAll(",\"times\":.*|,\"headerHash\":.*|\"bot\":\"[^\"]*\"", ""));
            }
        }
        return texts;
    }

    @Test
    void aWorkerThatTakesGuestsPlaysTheReplaysOfASingleMachine() throws Exception {
        assertReplaysOfASingleMachine("classes");
    }

    /** Such a program is a referee of {@link #aRefereeThatIsNotDeterministicConvictsNobody}, too. */
    @Test
    @Tag("campaign")
    void aWorkerThatTakesGuestsPlaysTheReplaysOfAProgram() throws Exception {
        assertReplaysOfASingleMachine("pairs");
    }

    private void assertReplaysOfASingleMachine(String mode) throws Exception {
        scene(mode);
        league("alone");
        done("run", "TMP/alone", "--games", "4", "--quiet");
        league("many");
        token("many", "closed");
        token("many", "open");
        CompletableFuture<String> run = serve("many", 4, "--threads", "0");
        Cli closed = join("closed");
        assertEquals(ExitStatus.REFUSED, closed.status(), closed.err());
        assertTrue(closed.err().contains("the scene has a referee of its own, and the worker runs none without "
            + "--guests"), closed.err());
        Cli open = join("open", "--guests", "--games", "4").done();
        String said = run.get();
        assertTrue(said.contains("worker closed plays nothing: the scene has a referee"), said);
        assertTrue(games("many").stream().allMatch(row -> row.machine().startsWith("worker open: ")), said);
        assertFalse(said.contains("doubtful") || said.contains("could not play"), said);
        assertEquals(counting("alone"), counting("many"), said);
        assertEquals(4, replays("many").size());
        assertEquals(replays("alone"), replays("many"));
    }

    @Test
    @Tag("campaign")
    void aClassPathThatWasChangedIsRefused() throws Exception {
        scene("classes");
        league("many");
        token("many", "open");
        CompletableFuture<String> run = serve("many", 2, "--threads", "0");
        assertEquals(ExitStatus.DONE, join("open", "--guests", "--games", "2").status());
        run.get();
        try (Stream<Path> files = Files.walk(folder.resolve("bundles of open"))) {
            Path jar = files.filter(file -> file.endsWith("core.jar")).findFirst().orElseThrow();
            Files.copy(folder.resolve("echo.sh"), jar, StandardCopyOption.REPLACE_EXISTING);
        }
        CompletableFuture<String> more = serve("many", 4, "--threads", "0");
        Cli changed = join("open", "--guests", "--games", "1");
        assertEquals(ExitStatus.REFUSED, changed.status(), changed.err());
        assertTrue(changed.err().matches("(?s).*found the jar sha256:\\S+ of the league's game, expected sha256:\\S+ "
            + ".*or of bundles \\(--bundles\\) for a guest\n"), changed.err());
        Files.move(folder.resolve("bundles of open"), folder.resolve("changed bundles"));
        assertEquals(ExitStatus.DONE, join("open", "--guests", "--games", "2").status());
        assertTrue(more.get().contains("worker open: found the jar sha256:"));
        Files.writeString(folder.resolve("target/classes/more.txt"), "other rules");
        Cli.league(folder, "run", "TMP/many", "--games", "6").assertRefused("the files of the game are others");
    }

    /** A difference when it is played again may be the referee's chance: nobody is convicted of it. */
    @Test
    void aRefereeThatIsNotDeterministicConvictsNobody() throws Exception {
        scene("chance");
        league("many");
        WorkerToken token = token("many", "open");
        Worker worker = worker(token, 1, Long.MAX_VALUE, Games.types(true));
        List<String> told = new CopyOnWriteArrayList<>();
        try (RemoteGames games = served("many", told::add)) {
            play(worker);
            while (told.isEmpty()) {
                TimeUnit.MILLISECONDS.sleep(10);       // until it has joined
            }
            assertEquals(Collections.singletonList(null), games.play(List.of(firstGame("many"))), told::toString);
        }
        assertTrue(worker.played() >= 1);
        assertTrue(told.stream().anyMatch(line -> line.startsWith("worker open could not play a game: game ")
            && line.contains("differs when it is played again")), told::toString);
        assertTrue(told.stream().noneMatch(line -> line.contains("caught")), told::toString);
    }

    /** A league need not ask whether the worker takes its referee, nor send the files, and may name others. */
    @Test
    void aWorkerRunsNoRefereeOfALeagueThatDoesNotAskOrSendsOtherFiles() throws Exception {
        scene("classes");
        league("many");
        WorkerToken token = token("many", "open");
        LeagueFolder league = new LeagueFolder(folder.resolve("many"));
        WorkerList list = WorkerList.read(league);
        LeagueWord.Welcome none = new LeagueWord.Welcome("1", "0123456789abcdef", null, 1, TimeBasis.WALL,
            Hiccups.COUNT, HoldPolicy.NEVER, Files.readString(folder.resolve("short.json")));
        Bundle outside = Bundle.of(new LeagueBot("referee", "codingame:/etc /usr", List.of(), false, false));
        LeagueWord.Welcome others = none.with(none.scene(), outside.hash(), outside.bytes().length);
        try (LeagueBroker broker = new LeagueBroker(new InetSocketAddress("127.0.0.1", port), new BrokerKey(league),
                List.of("open"), list::admits)) {
            assertRefused(broker, token, false, others, outside);
            assertRefused(broker, token, true, none, outside);
            assertRefused(broker, token, true, others, outside);
        }
    }

    private void assertRefused(LeagueBroker broker, WorkerToken token, boolean guests, LeagueWord.Welcome welcome,
                               Bundle bundle) throws Exception {
        Worker worker = worker(token, 1, 1, Games.types(guests));
        CompletableFuture<String> end = CompletableFuture.supplyAsync(() -> assertThrows(
            Worker.RefusedException.class, worker::play).getMessage());
        while (!end.isDone()) {
            LeagueBroker.Report report = broker.next(100);
            if (report != null && WorkerWord.read(report.bytes(), "m", Bundle.LARGEST) instanceof WorkerWord.Fetch) {
                broker.tell("open", WireMessage.bytes(new HeaderText().put("type", "bundle")
                    .put("bundle", bundle.hash()).put("from", 0).put("known", true), bundle.bytes()));
            } else if (report != null) {
                broker.tell("open", welcome.bytes());
            }
        }
        assertTrue(end.get().contains("expected --guests here, and its files from the league"), end.get());
    }
}
