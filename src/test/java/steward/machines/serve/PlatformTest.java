package steward.machines.serve;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.bot.command.Platform;
import steward.bot.isolation.Isolation;
import steward.cli.Cli;
import steward.cli.shared.Games;
import steward.machines.broker.BrokerClient;
import steward.machines.bundle.Bundle;
import steward.machines.token.WorkerToken;
import steward.machines.wire.GameJob;
import steward.machines.wire.HeaderText;
import steward.machines.wire.WireMessage;
import steward.machines.worker.Worker;

/** Bots that are for other platforms than this machine's, and games that no machine can play. */
@Tag("process")
@Tag("slow")
@Timeout(300)
@Execution(ExecutionMode.CONCURRENT)
class PlatformTest extends ServedLeague {

    private static final String FAR = "linux-s390x";
    private static final String FARTHER = "linux-riscv64";

    private Worker far(WorkerToken token) {
        return new Worker(new Worker.Options("127.0.0.1", port, token, 1, Long.MAX_VALUE, Long.MAX_VALUE,
            () -> Isolation.OFF, folder.resolve("bundles of " + token.worker()), FAR, "1", "far away"),
            Games.types(), what -> { });
    }

    /** Serves a league that need not come to its end. */
    private CompletableFuture<Cli> run(String league, int games, String... more) {
        List<String> words = new ArrayList<>(List.of("run", "TMP/" + league, "--games",
            Integer.toString(games), "--serve", "127.0.0.1:" + port));
        words.addAll(List.of(more));
        return CompletableFuture.supplyAsync(() -> Cli.league(folder, words.toArray(new String[0])));
    }

    @Test
    void aPlatformIsAVersionOfItsOwnThatPlaysThereOnly() throws Exception {
        make("many");
        done("add", "TMP/many", "fast=codingame:" + bots.driver(), "--platform", FAR);
        done("add", "TMP/many", "still=./no-such-program-here", "--platform", FARTHER);
        done("retire", "TMP/many", "still@" + FARTHER);
        assertTrue(done("list", "TMP/many").contains("  fast@" + FAR + ": codingame:sh "));
        WorkerToken near = token("many", "near");
        WorkerToken far = token("many", "far");
        CompletableFuture<String> run = serve("many", 40, "--threads", "1", "--again", "100");
        play(worker(near, 1, Long.MAX_VALUE));
        play(far(far));
        String said = run.get();
        List<Row> there = games("many").stream().filter(row -> row.game().contains("fast@" + FAR + ":")).toList();
        assertTrue(there.size() >= 12, said);
        assertTrue(there.stream().allMatch(row -> row.machine().equals("worker far: far away") && row.counts()), said);
        assertTrue(games("many").stream().anyMatch(row -> !row.machine().equals("worker far: far away")), said);
        assertTrue(said.matches("(?s).*\n +\\d+ +fast@" + FAR + " .*"), said);
        assertTrue(said.contains("worker near cannot play a bot: fast@" + FAR + ": found a bot for " + FAR
            + ", and this machine is " + Platform.here()), said);
        assertFalse(said.contains("plays by the clock") || said.contains("doubtful"), said);
        assertEquals(Cli.league(folder, "table", "TMP/many", "--csv").done().out().lines()
            .filter(line -> line.matches("\\d+,\"?fast@" + FAR + ".*")).count(), 1);
    }

    @Test
    @Tag("campaign")
    void theSameVersionTakesTheCommandOfTheMachineThatPlays() throws Exception {
        make("many");
        done("retire", "TMP/many", "wrong");
        done("add", "TMP/many", "still=codingame:" + bots.idler(2), "--platform", FAR, "--same");
        WorkerToken near = token("many", "near");
        WorkerToken far = token("many", "far");
        CompletableFuture<String> run = serve("many", 40, "--threads", "0", "--again", "0", "--pause-after", "0");
        play(worker(near, 1, Long.MAX_VALUE));
        play(far(far));
        String said = run.get();
        List<Row> games = games("many");
        assertTrue(games.stream().anyMatch(row -> row.machine().contains("far away"))
            && games.stream().anyMatch(row -> row.machine().contains("of the test")), said);
        games.forEach(row -> assertEquals(row.machine().contains("far away"),
            row.game().matches(".*still:\\d:[^:]*:line .*"), row.toString()));
        assertFalse(said.contains("still#2") || said.contains("@"), said);
    }

    /** Two leagues at the same time, as each waits for some seconds before it ends. */
    @Test
    @Tag("campaign")
    void whatRunsOnNoMachineEndsTheRunWithItsReason() throws Exception {
        CompletableFuture<Void> alone = CompletableFuture.runAsync(this::assertBotsOfDifferentPlatformsNeverMeet);
        assertALeagueThatPlaysNothingItselfSaysWhichBotRunsNowhere();
        alone.get();
    }

    /** The others play on. */
    private void assertBotsOfDifferentPlatformsNeverMeet() {
        make("few");
        done("add", "TMP/few", "a=codingame:" + bots.driver(), "--platform", FAR);
        done("add", "TMP/few", "b=codingame:" + bots.driver(), "--platform", FARTHER);
        Cli ended = Cli.league(folder, "run", "TMP/few", "--games", "1000");
        assertEquals(1, ended.status(), ended.err());
        assertTrue(ended.err().matches("(?s).*the league ends: no machine can play (\\S+ against [ab]@\\S+|[ab]@\\S+ "
            + "against \\S+): this machine is " + Platform.here() + "; expected a machine that can, .*"), ended.err());
        assertTrue(ended.err().contains("a round takes 18 games: 9 pairings "), ended.err());
        assertTrue(games("few").size() >= 8, "the others have played: " + games("few").size());
        List.of("fast", "still", "wrong").forEach(bot -> done("retire", "TMP/few", bot));
        Cli.league(folder, "run", "TMP/few").assertRefused("found at most 1 bot for any one platform, expected at "
            + "least 2 that can play together");
    }

    @Test
    void whatIsNoPlatformIsRefused() {
        make("few");
        String bot = "new=codingame:" + bots.driver();
        Cli.league(folder, "add", "TMP/few", bot, "--platform", "linux-amd64").assertRefused(
            "--platform: found 'linux-amd64', expected a platform such as linux-x86_64 or linux-aarch64");
        Cli.league(folder, "add", "TMP/few", bot, "--same").assertRefused("--same is for --platform, expected both");
        Cli.league(folder, "add", "TMP/few", bot, "--platform", FAR, "--same").assertRefused("found no bot 'new'");
        Cli.league(folder, "add", "TMP/few", bot, "--platform", FAR, "--check").assertRefused("--check: found a "
            + "command for " + FAR + ", expected one for this machine");
        done("add", "TMP/few", "fast=./arm", "--platform", FAR, "--same");
        Cli.league(folder, "add", "TMP/few", "fast=./other", "--platform", FAR, "--same").assertRefused(
            "bot 'fast': found a command for " + FAR + " already");
        done("add", "TMP/few", "fast=./arm", "--platform", FAR);
        Cli.league(folder, "add", "TMP/few", "fast=./arm2", "--platform", FAR).assertRefused("found a bot 'fast@" + FAR
            + "' in the league, expected another name");
        Cli.league(folder, "rename", "TMP/few", "fast@" + FAR, "quick").assertRefused("and '@" + FAR + "' after them");
        done("rename", "TMP/few", "fast@" + FAR, "quick@" + FAR);
        Cli.run("worker", "--join", "h:1", "--platform", "arm").assertRefused("--platform: found 'arm', expected");
    }

    private void assertALeagueThatPlaysNothingItselfSaysWhichBotRunsNowhere() throws Exception {
        make("many");
        WorkerToken token = token("many", "bare");
        CompletableFuture<Cli> run = run("many", 1000, "--threads", "0", "--quiet");
        try (BrokerClient client = client(token)) {
            hello(client, "bare");
            String bundle = null;
            while (bundle == null) {
                try (BrokerClient.Taker taker = client.taker(List.of())) {
                    byte[] bytes = taker.take(500);
                    GameJob job = bytes == null ? null : GameJob.read(bytes, "a job", Bundle.LARGEST);
                    bundle = job == null ? null : job.games().get(0).seats().stream().filter(seat ->
                        seat.name().equals("fast")).map(GameJob.Seat::bundle).findFirst().orElse(null);
                    if (job != null && bundle == null) {
                        report(taker, job, job.games().size());
                    }
                }
            }
            client.say(WireMessage.bytes(new HeaderText().put("type", "unfit").put("bundle", bundle)
                .put("reason", "fast does not run here: no such library")));
            List<String> unfit = List.of(bundle);
            while (!run.isDone()) {
                try (BrokerClient.Taker taker = client.taker(unfit)) {
                    byte[] bytes = taker.take(200);
                    if (bytes != null) {
                        GameJob job = GameJob.read(bytes, "a job", Bundle.LARGEST);
                        report(taker, job, job.games().size());
                    }
                }
            }
        } catch (BrokerClient.BrokenException closed) {
            run.join();                                // which has ended, then
        }
        Cli ended = run.get();
        assertEquals(1, ended.status(), ended.err());
        assertTrue(ended.err().matches("(?s).*the league ends: no machine can play (fast against \\w+|\\w+ against "
            + "fast): worker bare: fast does not run here: no such library; expected .*"), ended.err());
        assertTrue(games("many").stream().noneMatch(row -> row.game().contains("fast")));
        assertTrue(games("many").size() >= 8, "the others have played: " + games("many").size());
    }

    /** {@code StandstillTest} has when and how often. */
    @Test
    @Tag("campaign")
    void gamesThatWaitForAWorkerAreSaidTo() throws Exception {
        make("many");
        CompletableFuture<Cli> run = run("many", 6, "--threads", "0", "--for", "9s");
        Cli ended = run.get().done();
        assertEquals(1, ended.err().split("games wait for a worker: none is connected, and this league plays none "
            + "itself", -1).length - 1, ended.err());
    }
}
