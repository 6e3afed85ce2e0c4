package steward.machines.serve;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import steward.league.StoredGame;
import steward.league.play.RemoteMachines;
import steward.machines.broker.BrokerClient;
import steward.machines.broker.BrokerClient.BrokenException;
import steward.machines.bundle.Bundle;
import steward.machines.serve.HostileWorker.Way;
import steward.machines.token.WorkerToken;
import steward.machines.wire.GameJob;
import steward.machines.wire.HeaderText;
import steward.machines.wire.WireMessage;
import steward.machines.wire.WorkerWord;

/**
 * Fate of workers that lie, fail or keep games, and of honest ones with unusual bots. It takes long because games of a
 * liar are asked again, and leagues look at their lists once a second.
 */
@Tag("process")
@Tag("slow")
@Timeout(300)
class WorkerVerdictsTest extends ServedLeague {

    private int lag = 64;
    private List<String> alone;

    private HostileWorker hostile(Way way) {
        return new HostileWorker(way, folder.resolve("short.json").toString(), (name, honest) -> "codingame:"
            + (name.equals("fast") == honest ? bots.driver() : bots.idler(honest && name.equals("wrong") ? 3 : 0)));
    }

    /** Makes a league for workers, and knows its games on a single machine. */
    private void alone(int games) throws Exception {
        alone = alone(games, lag, "--pause-after", "0");
        make("many");
        lag("many", lag);
    }

    /** Plays a league beside a hostile worker, which ends with it. */
    private String beside(HostileWorker hostile, int games, String... options) throws Exception {
        WorkerToken token = token("many", "bad");
        CompletableFuture<String> run = serve("many", games, options);
        try (BrokerClient client = client(token)) {
            hostile.play(client, run::isDone);
        } catch (BrokenException closed) {
            run.join();                                // which has ended, or has sent it away
        }
        return run.get();
    }

    /** The honest worker comes when the other one is caught, and plays its games again and the rest. */
    @Test
    void aWorkerWhoseStatesDifferIsCaughtRevokedAndItsGamesAreSetAside() throws Exception {
        alone(20);
        WorkerToken other = token("many", "good");
        WorkerToken token = token("many", "bad");
        CompletableFuture<String> run = serve("many", 20, "--threads", "0", "--pause-after", "0");
        try (BrokerClient client = client(token)) {
            HostileWorker hostile = hostile(Way.STATES);
            assertThrows(BrokenException.class, () -> hostile.play(client, run::isDone), "its connection is closed");
        }
        play(worker(other, 1, Long.MAX_VALUE));
        String said = run.get();

        assertTrue(said.contains("worker bad is caught and revoked: "), said);
        assertTrue(said.contains("differs when it is played again: found states of the hash x"), said);
        Matcher count = Pattern.compile("; ([1-3]) of its games are set aside and played again").matcher(said);
        assertTrue(count.find(), said);
        String heading = "20 games of duel, " + count.group(1) + " more set aside, of workers that were caught\n";
        assertTrue(said.contains(heading), said);
        String table = done("table", "TMP/many");
        assertTrue(table.startsWith(heading), table);
        assertTrue(table.contains("worker bad: caught, 0 games, " + count.group(1)
            + " more set aside, 0 faults, 0 hiccups\n"), table);
        assertTrue(done("table", "TMP/many", "--json").contains("\"workers\":[{\"name\":\"bad\",\"state\":\"caught\","
            + "\"games\":0,\"aside\":" + count.group(1) + ","));
        done("page", "TMP/many", "--out", "TMP/page.html");
        assertTrue(Files.readString(folder.resolve("page.html")).contains("\"name\":\"bad\",\"state\":\"caught\""));
        assertEquals(alone, counting("many"), said);
        assertTrue(done("worker", "list", "TMP/many").contains("bad (revoked: caught: game "));
        try (RemoteGames games = served("many")) {
            assertTrue(games.seen().isEmpty());
            assertTrue(refused(token).contains("wrong or revoked"), "also by the next run");
            done("worker", "pardon", "TMP/many", "bad");
            assertTrue(joins(token), "the league looks at its list once a second");
        }
    }

    private boolean joins(WorkerToken token) throws InterruptedException {
        for (int tries = 0; tries < 100; tries++) {
            try {
                client(token).close();
                return true;
            } catch (BrokenException notYet) {
                Thread.sleep(200);
            }
        }
        return false;
    }

    /**
     * All follows from its commands: that they are not the bot's is for the operator to judge, with the evidence. Until
     * then its games do not count, and an honest worker beside it is not doubtful.
     */
    @Test
    void aWorkerThatAnswersForABotIsSuspendedUntilTheOperatorDecides() throws Exception {
        alone(20);
        WorkerToken other = token("many", "good");
        WorkerToken token = token("many", "bad");
        CompletableFuture<String> run = serve("many", 20, "--threads", "0", "--pause-after", "0");
        CompletableFuture<Void> forging = CompletableFuture.runAsync(() -> {
            try (BrokerClient client = client(token)) {
                hostile(Way.ANSWERS).play(client, run::isDone);
            } catch (BrokenException | InterruptedException closed) {
                return;
            }
        });
        String suspended = "bad (suspended: its games do not count until pardon or revoke)\n  doubtful: ";
        while (!run.isDone() && !done("worker", "list", "TMP/many").contains(suspended)) {
            TimeUnit.MILLISECONDS.sleep(200);
        }
        play(worker(other, 1, Long.MAX_VALUE));
        String said = run.get();
        forging.get();
        assertFalse(said.contains("caught") || said.contains("worker good is doubtful"), said);
        assertTrue(Pattern.compile("worker bad is doubtful: \\w+ answered otherwise than here in 5 of \\d+ games that "
            + "were asked again, here the same twice \\(no other worker to compare with\\), such as turn ")
            .matcher(said).find(), said);
        Matcher count = Pattern.compile("worker bad is suspended: (\\d+) games of it leave the table").matcher(said);
        assertTrue(count.find(), said);
        String table = done("table", "TMP/many");
        assertTrue(table.startsWith(20 - Integer.parseInt(count.group(1)) + " games of duel, " + count.group(1)
            + " more of workers that are suspended\n") && table.contains("worker bad: suspended, 0 games, "), table);
        assertTrue(alone.containsAll(counting("many")), "what counts is honest");
        try (RemoteGames games = served("many"); BrokerClient client = client(token)) {
            assertTrue(done("worker", "list", "TMP/many", "--json").contains("\"suspended\":true,\"doubts\":[\""));
            assertTrue(games.seen().stream().filter(worker -> worker.name().equals("bad"))
                .allMatch(worker -> worker.slots() == 0), "also in the next run");
        }
        assertEquals("bad may play again; " + count.group(1) + " games count again\n", done("worker", "pardon",
            "TMP/many", "bad"));
        assertTrue(done("table", "TMP/many").startsWith("20 games of duel\n"));
        assertFalse(alone.equals(counting("many")), "its games count");

        done("worker", "revoke", "TMP/many", "bad", "--set-aside");
        said = serve("many", 20, "--threads", "1", "--pause-after", "0").get();
        assertTrue(Pattern.compile("worker bad is revoked; \\d+ of its games are set aside")
            .matcher(said).find(), said);
        assertEquals(alone, counting("many"), said);
    }

    private void add(String name, String script) throws Exception {
        Path file = folder.resolve(name + ".sh");
        Files.writeString(file, "#!/bin/sh\nwhile read -r x y nextX nextY rest && read -r other; do\n" + script
            + "\ndone\n");
        done("add", "TMP/many", name + "=codingame:sh '" + file + "'");
    }

    @Test
    void aWorkerIsHonestWhoseBotPlaysByTheClockOrFailsOnlyHere() throws Exception {
        make("many");
        add("clock", ": ${began:=$(($(date +%s%N) % 1000000))}; echo \"$((nextX + began)) $nextY 50\"");
        add("there", "case \"$0\" in *bundles*) echo \"$nextX $nextY 50\" ;; *) exit 3 ;; esac");
        WorkerToken token = token("many", "good");
        CompletableFuture<String> run = serve("many", 20, "--threads", "0", "--pause-after", "0");
        play(worker(token, 1, Long.MAX_VALUE));
        String said = run.get();
        assertTrue(said.contains("clock plays by the clock: each time it is asked it answers otherwise: turn "), said);
        assertTrue(said.contains("there fails on the league's machine, and does not on worker good: turn 1: found a "
            + "command, expected the fault 'exited with status 3"), said);
        assertEquals(2, said.split("it is not asked again in this run", -1).length - 1, "each is said once: " + said);
        assertTrue(said.startsWith("20 games of duel\n") || said.contains("\n20 games of duel\n"), said);
        assertFalse(said.contains("caught") || said.contains("doubtful: clock"), said);
        assertEquals("good\n", done("worker", "list", "TMP/many"));
    }

    @Test
    @Tag("campaign")
    void latenessThatTheWorkersOwnTimesDoNotAllowIsNotBelieved() throws Exception {
        alone(240);                                    // so many that it has joined before they are played
        String said = beside(hostile(Way.EARLY), 240, "--threads", "1", "--pause-after", "0");
        assertTrue(said.contains("worker bad could not play a game: game "), said);
        assertTrue(said.contains("after 0 us, expected a late answer only after 60"), said);
        assertEquals(alone, counting("many"), said);
    }

    @Test
    @Tag("campaign")
    void latenessThatHasNotPassedIsNotBelieved() throws Exception {
        alone(240);                                    // so many that it has joined before they are played
        String said = beside(hostile(Way.LATE), 240, "--threads", "1", "--pause-after", "0");
        assertTrue(said.contains("us, expected no more than the time since the worker was handed the game"), said);
        assertEquals(alone, counting("many"), said);
    }

    /** The schedule may be 4 decisions ahead, so that each game that is kept counts. */
    @Test
    @Tag("campaign")
    void aWorkerThatKeepsItsGamesStopsNobody() throws Exception {
        assertAWorkerThatKeepsItsGamesStopsNobody(12, "1s");
    }

    /** Far from the lease: how long a worker may keep games follows from what the bots took before. */
    @Test
    @Tag("campaign")
    void aWorkerThatKeepsItsGamesStopsNobodyForALongLease() throws Exception {
        assertAWorkerThatKeepsItsGamesStopsNobody(60, "10h");
    }

    private void assertAWorkerThatKeepsItsGamesStopsNobody(int games, String lease) throws Exception {
        lag = 4;
        alone(games);
        String said = beside(hostile(Way.KEEPS), games, "--threads", "1", "--pause-after", "0", "--lease", lease);
        assertTrue(said.contains("worker bad could not play a game: it has not finished its games within "), said);
        assertEquals(alone, counting("many"), said);
    }

    /** A full disk, say: it is told once, and the worker is tried less and less often. */
    @Test
    @Tag("campaign")
    void aWorkerThatFailsAtEachGameIsPaused() throws Exception {
        alone(60);
        HostileWorker full = hostile(Way.FAILS);
        String said = beside(full, 60, "--threads", "1", "--pause-after", "0");
        assertEquals(2, said.split("bad could not play a game: no space left", -1).length, said);
        assertTrue(said.contains("; it is paused, and tried with one job after 1 s, 2 s, 4 s and so on\n"), said);
        assertTrue(full.jobs() <= 15, () -> "found " + full.jobs() + " jobs: " + said);
        assertEquals(alone, counting("many"), said);
    }

    /** Result of the league's first game, offered to its workers. */
    private CompletableFuture<List<List<StoredGame>>> played(RemoteGames games) {
        return played(games, firstGame("many"));
    }

    private static CompletableFuture<List<List<StoredGame>>> played(RemoteGames games, RemoteMachines.Game game) {
        return CompletableFuture.supplyAsync(() -> {
            try {
                return games.play(List.of(game));
            } catch (InterruptedException end) {
                return List.of();
            }
        });
    }

    /** With bots that have not played yet a worker may take the lease, 4 s, and in a hurry a quarter of it. */
    @Test
    @Tag("campaign")
    void whoHasNothingElseToPlayWaitsForNoLeaseAndTheWorkerIsBlamedWhenItEnds() throws Exception {
        make("many");
        WorkerToken token = token("many", "bad");
        List<String> told = new CopyOnWriteArrayList<>();
        AtomicBoolean over = new AtomicBoolean();
        try (RemoteGames games = served("many", false, TimeUnit.SECONDS.toNanos(4), told::add);
             BrokerClient client = client(token)) {
            CompletableFuture<Void> keeping = CompletableFuture.runAsync(() -> {
                try {
                    hostile(Way.KEEPS).play(client, over::get);
                } catch (BrokenException | InterruptedException closed) {
                    return;
                }
            });
            while (told.isEmpty()) {
                TimeUnit.MILLISECONDS.sleep(10);       // until it has joined
            }
            CompletableFuture<List<List<StoredGame>>> played = played(games);
            while (!played.isDone()) {
                games.hurry();
                TimeUnit.MILLISECONDS.sleep(50);
            }
            assertEquals(Collections.singletonList(null), played.get());
            assertEquals(1, told.size(), () -> "nobody is blamed yet: " + told);
            while (told.size() == 1) {
                TimeUnit.MILLISECONDS.sleep(50);
            }
            assertTrue(told.get(1).matches("worker bad could not play a game: it has not finished its games within "
                + "[4-9] s, and .*"), told::toString);
            over.set(true);
            keeping.get();
        }
    }

    /** Tests of a worker that is paused: its games have gone to others, or a bot does not run there. */
    @Test
    @Tag("campaign")
    void aTestWhoseGamesHaveGoneToOthersIsGivenAnew() throws Exception {
        make("many");
        try (RemoteGames games = served("many", false, TimeUnit.SECONDS.toNanos(4), told -> { });
             BrokerClient client = client(token("many", "slow"))) {
            hello(client, "slow");
            try (BrokerClient.Taker taker = client.taker(List.of())) {
                CompletableFuture<List<List<StoredGame>>> first = played(games);
                fail(taker, take(taker));
                assertEquals(Collections.singletonList(null), first.get());
                CompletableFuture<List<List<StoredGame>>> second = played(games);
                GameJob test = take(taker);
                while (!second.isDone()) {
                    games.hurry();
                    TimeUnit.MILLISECONDS.sleep(50);
                }
                fail(taker, test);
                CompletableFuture<List<List<StoredGame>>> third = played(games);
                GameJob another = take(taker);
                client.say(WireMessage.bytes(new HeaderText().put("type", "unfit").put("bundle",
                    another.games().get(0).seats().get(1).bundle()).put("reason", "no such program")));
                assertEquals(Collections.singletonList(null), third.get(), "nobody can play it");
            }
            try (BrokerClient.Taker taker = client.taker(List.of())) {
                RemoteMachines.Game others = game("many", 0, 2);
                CompletableFuture<List<List<StoredGame>>> fourth = played(games, others);
                while (!fourth.isDone()) {
                    byte[] job = taker.take(200);
                    if (job != null) {                 // what it gave back may come before
                        fail(taker, GameJob.read(job, "a job", Bundle.LARGEST));
                    }
                }
            }
        }
    }

    private static GameJob take(BrokerClient.Taker taker) throws Exception {
        byte[] job = null;
        while (job == null) {
            job = taker.take(500);
        }
        return GameJob.read(job, "a job", Bundle.LARGEST);
    }

    private static void fail(BrokerClient.Taker taker, GameJob job) throws BrokenException {
        taker.finish(new WorkerWord.Result(job.id(), List.of(new WorkerWord.Played(List.of(), List.of(),
            "no space left on device", null))).bytes());
    }
}
