package steward.machines.serve;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.InputStream;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import javax.net.ssl.SSLException;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.league.LeagueFolder;
import steward.league.LeagueSettings;
import steward.machines.broker.BrokerClient.BrokenException;
import steward.machines.broker.BrokerClient;
import steward.machines.broker.CutProxy;
import steward.machines.bundle.Bundle;
import steward.machines.token.BrokerKey;
import steward.machines.token.Invitation;
import steward.machines.token.WorkerToken;
import steward.machines.wire.GameJob;
import steward.machines.wire.HeaderText;
import steward.machines.wire.WireMessage;
import steward.machines.worker.Worker;
import steward.scene.RungLaw;

/** A league whose games workers play, in this JVM: honest ones, forging ones, and such as may not. */
@Tag("process")
@Tag("slow")
@Timeout(300)
@Execution(ExecutionMode.CONCURRENT)
class WorkerTest extends ServedLeague {

    private static final int GAMES = 60;

    @Test
    void theGamesAreThoseOfASingleMachine() throws Exception {
        List<String> alone = alone(GAMES, LeagueSettings.USUAL_LAG);
        make("many");
        WorkerToken one = token("many", "one");
        WorkerToken two = token("many", "two");
        CompletableFuture<String> run = serve("many", GAMES, "--threads", "0");
        play(worker(one, 2, Long.MAX_VALUE));
        play(worker(two, 1, Long.MAX_VALUE));
        String said = run.get();

        assertEquals(alone, counting("many"), said);
        assertTrue(games("many").stream().anyMatch(row -> row.machine().startsWith("worker one: a machine of")), said);
        assertTrue(said.contains("worker one: 2 at a time, "), said);
    }

    /** Both are cut in the middle of a message, and join again when connections are taken again. */
    @Test
    void nothingIsLostOrDoubledWhenConnectionsAreCut() throws Exception {
        List<String> alone = alone(GAMES, LeagueSettings.USUAL_LAG);
        make("many");
        WorkerToken one = token("many", "one");
        WorkerToken two = token("many", "two");
        int league = port;
        CompletableFuture<String> run = serve("many", GAMES, "--threads", "0");
        try (CutProxy proxy = new CutProxy(league)) {
            client(one).close();                       // the league listens
            port = proxy.port();
            Worker first = worker(one, 2, Long.MAX_VALUE);
            Worker second = worker(two, 1, Long.MAX_VALUE);
            play(first);
            play(second);
            while (first.played() + second.played() < GAMES / 4) {
                TimeUnit.MILLISECONDS.sleep(5);
            }
            while (proxy.cut(300) == 0) {
                assertFalse(run.isDone(), "no connection was cut within a message");
            }
            assertFalse(run.isDone(), "games are left when connections are taken again");
            String said = run.get();
            assertEquals(alone, counting("many"), said);
        }
    }

    /** Of each second job it leaves out the last game, if it has several; how many it has left out. */
    private int leaveOut(BrokerClient client, CompletableFuture<String> run) throws BrokenException,
            InterruptedException {
        int left = 0;
        hello(client, "lazy");
        try (BrokerClient.Taker taker = client.taker(List.of())) {
            for (int jobs = 0; !run.isDone();) {
                byte[] bytes = taker.take(500);
                if (bytes == null) {
                    continue;
                }
                GameJob job = GameJob.read(bytes, "a job", Bundle.LARGEST);
                int games = Math.max(1, job.games().size() - jobs++ % 2);
                left += job.games().size() - games;
                report(taker, job, games);
            }
        } catch (BrokenException closed) {
            run.join();                                // which has ended, then
        }
        return left;
    }

    @Test
    @Tag("campaign")
    void gamesOfAJobThatWereNotBegunArePlayedLater() throws Exception {
        List<String> alone = alone(GAMES, LeagueSettings.USUAL_LAG);
        make("many");
        WorkerToken token = token("many", "lazy");
        CompletableFuture<String> run = serve("many", GAMES, "--quiet");
        try (BrokerClient client = client(token)) {
            int left = leaveOut(client, run);
            assertEquals(alone, counting("many"), () -> left + " left out");
        }
    }

    /** Plays what it is given, but has no bot of one name; how many games it has played. */
    private int without(String bot, BrokerClient client, CompletableFuture<String> run) throws BrokenException,
            InterruptedException {
        List<String> unfit = new ArrayList<>();
        int games = 0;
        hello(client, "bare");
        try {
            while (!run.isDone()) {
                try (BrokerClient.Taker taker = client.taker(unfit)) {
                    byte[] bytes = taker.take(500);
                    if (bytes == null) {
                        continue;
                    }
                    GameJob job = GameJob.read(bytes, "a job", Bundle.LARGEST);
                    job.games().stream().flatMap(game -> game.seats().stream()).filter(seat -> seat.name().equals(bot))
                        .forEach(seat -> unfit.add(seat.bundle()));
                    if (!unfit.isEmpty() && job.games().stream().anyMatch(game -> game.seats().stream()
                            .anyMatch(seat -> unfit.contains(seat.bundle())))) {
                        client.say(WireMessage.bytes(new HeaderText().put("type", "unfit").put("bundle", unfit.get(0))
                            .put("reason", bot + " does not run here")));
                        continue;
                    }
                    report(taker, job, job.games().size());
                    games += job.games().size();
                }
            }
        } catch (BrokenException closed) {
            run.join();                                // which has ended, then
        }
        return games;
    }

    @Test
    @Tag("campaign")
    void gamesOfABotThatRunsOnNoWorkerArePlayedByTheLeague() throws Exception {
        List<String> alone = alone(GAMES, LeagueSettings.USUAL_LAG);
        make("many");
        WorkerToken token = token("many", "bare");
        CompletableFuture<String> run = serve("many", GAMES, "--threads", "1");
        try (BrokerClient client = client(token)) {
            int games = without("still", client, run);
            assertEquals(alone, counting("many"), () -> games + " games of the worker");
            assertTrue(games("many").stream().noneMatch(row -> row.machine().startsWith("worker bare")
                && row.game().contains("still")));
            assertTrue(run.join().contains("worker bare cannot play a bot: still does not run here"), run.join());
        }
    }

    /** Each has another bot that does not run there: a job must not need both. */
    @Test
    @Tag("campaign")
    void twoWorkersThatBothLackABotPlayTheGamesThatTheyCan() throws Exception {
        List<String> alone = alone(GAMES, LeagueSettings.USUAL_LAG);
        make("many");
        WorkerToken one = token("many", "one");
        WorkerToken two = token("many", "two");
        CompletableFuture<String> run = serve("many", GAMES, "--threads", "1");
        try (BrokerClient first = client(one); BrokerClient second = client(two)) {
            CompletableFuture<Integer> other = CompletableFuture.supplyAsync(() -> {
                try {
                    return without("wrong", second, run);
                } catch (BrokenException | InterruptedException problem) {
                    throw new IllegalStateException(problem);
                }
            });
            int games = without("still", first, run) + other.join();
            assertEquals(alone, counting("many"), () -> games + " games of the workers");
            assertTrue(run.join().contains("worker one cannot play a bot: still does not run here"), run.join());
            assertTrue(games("many").stream().noneMatch(row -> row.machine().startsWith("worker one")
                && row.game().contains("still") || row.machine().startsWith("worker two")
                && row.game().contains("wrong")));
        }
    }

    @Test
    void whoMayNotJoinIsRefused() throws Exception {
        make("many");
        WorkerToken good = token("many", "good");
        BrokerKey key = new BrokerKey(new LeagueFolder(folder.resolve("many")));
        String fingerprint = key.fingerprint();
        done("worker", "renew", "TMP/many");
        assertEquals(fingerprint, key.fingerprint(), "the key stays");
        try (RemoteGames games = served("many"); BrokerClient older = client(good);
             BrokerClient client = new BrokerClient("127.0.0.1", port, good, "a newer process")) {
            assertTrue(games.seen().isEmpty());
            assertThrows(BrokenException.class, () -> listen(older), "the newer one has taken over");
            assertTrue(refused(new WorkerToken("good", "x".repeat(43), good.broker())).contains("wrong or revoked"));
            assertTrue(refused(new WorkerToken("nobody", good.secret(), good.broker())).contains("wrong or revoked"));
            assertTrue(refused(new WorkerToken("good", good.secret(), "0".repeat(64))).contains("has another key"));
            assertTrue(refused(good).contains("another worker plays with this token"));
            try (Socket plain = new Socket("127.0.0.1", port); InputStream in = plain.getInputStream()) {
                plain.getOutputStream().write("ARTEMIS\n\n\n\n\n\n\n\n".getBytes(StandardCharsets.UTF_8));
                plain.setSoTimeout(30_000);
                int first = in.read();
                assertTrue(first < 0 || first == 21, "closed, or an alert of TLS: " + first);
            }
            assertThrows(SSLException.class, () -> TrustingClient.shakeHands(port, "TLSv1.2"));
            assertEquals("TLSv1.3", TrustingClient.shakeHands(port, "TLSv1.3"),
                "the same client in the version that is wanted");
            done("worker", "revoke", "TMP/many", "good");
            assertThrows(BrokenException.class, () -> listen(client));
            assertTrue(refused(good).contains("wrong or revoked"));
        }
    }

    @Test
    void versionsThatComputeOtherResultsDoNotPlayTogether() throws Exception {
        make("many");
        WorkerToken token = token("many", "old");
        List<String> told = new CopyOnWriteArrayList<>();
        try (RemoteGames games = served("many", told::add); BrokerClient client = client(token)) {
            assertTrue(games.seen().isEmpty());
            client.say(WireMessage.bytes(new HeaderText().put("type", "hello").put("version", "0.0.9")
                .put("bits", "0123456789abcdef").put("machine", "an old machine").put("slots", 1)));
            WireMessage message = WireMessage.read(listen(client), "the league");
            assertEquals("refused", message.header().text("type"));
            String reason = message.header().text("reason");
            assertEquals("found Steward 0.0.9 (results 0123456789abcdef) on worker old and Steward 1 (results "
                + RungLaw.WHOLE_LADDER + ") in the league, expected versions that compute the same", reason);
            assertEquals(List.of(reason), told, "the league says it, too");

            client.say(WireMessage.bytes(new HeaderText().put("type", "hello").put("version", "0.0.8")
                .put("bits", RungLaw.keys()).put("machine", "a machine").put("slots", 2)));
            client.say(WireMessage.bytes(new HeaderText().put("type", "differs").put("rules", "fedcba9876543210")));
            while (told.size() < 3) {
                TimeUnit.MILLISECONDS.sleep(10);
            }
            assertTrue(told.get(2).startsWith("found Steward 0.0.8 (results fedcba9876543210) on worker old and "
                + "Steward 1 (results "), told::toString);
            assertEquals(0, games.seen().get(0).slots(), "it is given no games");
        }
    }

    @Test
    void machinesJoinWithAnInvitationAndAreRevokedOneByOne() throws Exception {
        make("many");
        done("worker", "invite", "TMP/many", "--count", "2", "--until", "2999-12-24", "--out", "TMP/letter");
        Invitation.Letter letter = Invitation.letter(folder.resolve("letter"));
        List<String> told = new CopyOnWriteArrayList<>();
        try (RemoteGames games = served("many", told::add)) {
            List<WorkerToken> tokens = new ArrayList<>();
            for (String host : List.of("attic", "cellar", "shed")) {
                tokens.add(WorkerToken.invited(letter, folder.resolve("keys").resolve(host), host));
            }
            for (WorkerToken token : tokens.subList(0, 2)) {
                try (BrokerClient client = client(token)) {
                    hello(client, token.worker());
                    assertEquals("welcome", WireMessage.read(listen(client), "the league").header().text("type"));
                }
            }
            client(tokens.get(0)).close();             // a second time, with its own key
            assertEquals("the invitation invitation is used up: 2 of 2 machines have joined with it",
                refused(tokens.get(2)));
            String one = tokens.get(0).worker();
            assertTrue(told.contains("worker " + one + " has come with the invitation invitation"), told::toString);
            assertTrue(done("worker", "list", "TMP/many").matches("(?s)" + one + " \\(by invitation\\)\n.*"
                + "invitation: an invitation until 2999-.*, used by 2 of 2 machines\n"));
            String json = done("worker", "list", "TMP/many", "--json");
            assertTrue(json.startsWith("{\"workers\":[{\"name\":\"" + one + "\",\"invitation\":\"invitation\","
                + "\"revoked\":null,\"suspended\":false,\"doubts\":[]}")
                && json.contains("\"used\":2,\"count\":2,\"revoked\":false}"), json);
            done("worker", "revoke", "TMP/many", one);
            while (!told.contains("worker " + one + " is revoked") && !refusedNow(tokens.get(0))) {
                TimeUnit.MILLISECONDS.sleep(50);
            }
            assertEquals("the key of " + one + " is revoked, or another machine has this name", refused(tokens.get(0)));
            client(tokens.get(1)).close();
        }
    }

    private boolean refusedNow(WorkerToken token) {
        try {
            new BrokerClient("127.0.0.1", port, token, "p").close();
            return false;
        } catch (BrokenException refused) {
            return refused.isRefused();
        }
    }

    /** The scene gives it a minute for the first answer. */
    @Test
    void aBotsOwnLimitHoldsOnAWorker() throws Exception {
        done("init", "TMP/own", "--scene", "TMP/short.json", "--seed", "5");
        done("add", "TMP/own", "still=codingame:" + bots.idler(0));
        done("add", "TMP/own", "mute=codingame:sleep 100", "--time-limit", "20,30");
        WorkerToken token = token("own", "one");
        CompletableFuture<String> run = serve("own", 2, "--threads", "0");
        play(worker(token, 1, Long.MAX_VALUE));
        run.get();
        String failed = done("games", "TMP/own", "--failed");
        assertEquals(2, failed.split("mute failed in turn 1: no answer within 30 ms \\(waited ", -1).length - 1,
            failed);
    }

    /** A worker that is slower than anything: its limits are eight times the league's, which is the most. */
    @Test
    @Tag("campaign")
    void timeLimitsAreScaledByTheSpeedOfAMachine() throws Exception {
        make("many");
        WorkerToken token = token("many", "slow");
        List<String> told = new CopyOnWriteArrayList<>();
        try (RemoteGames games = served("many", true, told::add); BrokerClient client = client(token)) {
            assertTrue(games.seen().isEmpty());
            client.say(WireMessage.bytes(new HeaderText().put("type", "hello").put("version", "1")
                .put("bits", RungLaw.keys()).put("machine", "a snail").put("slots", 1).put("speed", 1)));
            assertEquals("8.0", WireMessage.read(listen(client), "the league").header().text("factor"));
            assertEquals(List.of("worker slow plays 1 game at a time: a snail, time limits times 8.0"), told);
        }
        CompletableFuture<String> run = serve("many", 20, "--threads", "0", "--scale-time");
        play(worker(token, 1, Long.MAX_VALUE));
        String said = run.get();
        assertTrue(games("many").stream().allMatch(row -> row.machine().matches(
            "worker slow: a machine of the test, time limits times [0-9.]+")), said);
    }

    /** The league looks at its list some times a second; who joins at once need not wait for that. */
    @Test
    @Tag("campaign")
    void aWorkerMayJoinAsSoonAsItIsAdded() throws Exception {
        make("many");
        try (RemoteGames games = served("many")) {
            for (String name : List.of("one", "two", "three", "four")) {
                new BrokerClient("127.0.0.1", port, token("many", name), "p").close();
            }
        }
    }
}
