package steward.machines.serve;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.networknt.schema.Error;
import com.networknt.schema.InputFormat;
import com.networknt.schema.Schema;
import com.networknt.schema.SchemaRegistry;
import com.networknt.schema.SpecificationVersion;
import java.io.IOException;
import java.io.InputStream;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import steward.bot.command.Platform;
import steward.bot.isolation.Isolation;
import steward.cli.FreePort;
import steward.cli.shared.Games;
import steward.files.InputException;
import steward.league.LeagueFolder;
import steward.machines.broker.BrokerClient;
import steward.machines.broker.BrokerClient.BrokenException;
import steward.machines.broker.LeagueBroker;
import steward.machines.bundle.Bundle;
import steward.machines.token.BrokerKey;
import steward.machines.token.WorkerList;
import steward.machines.token.WorkerToken;
import steward.machines.wire.GameJob;
import steward.machines.wire.HeaderText;
import steward.machines.wire.WireMessage;
import steward.machines.wire.WorkerWord;
import steward.machines.worker.Worker;
import steward.scene.RungLaw;

/**
 * All that a league and a worker say is as the schema says. A made-up worker writes down the league's messages; then a
 * made-up league says the same to a real worker. It takes long because the league has so many games that a worker joins
 * in time.
 */
@Tag("process")
@Tag("slow")
@Timeout(300)
@Execution(ExecutionMode.CONCURRENT)
class MessageSchemaTest extends ServedLeague {

    private static final Schema SCHEMA = schema();

    private final Set<String> types = new TreeSet<>();

    private static Schema schema() {
        try (InputStream in = MessageSchemaTest.class.getResourceAsStream("/steward/schemas/machines.json")) {
            return SchemaRegistry.withDefaultDialect(SpecificationVersion.DRAFT_2020_12)
                .getSchema(new String(in.readAllBytes(), StandardCharsets.UTF_8), InputFormat.JSON);
        } catch (IOException problem) {
            throw new IllegalStateException(problem);
        }
    }

    /** Checks a message; what type it is. */
    private String checked(byte[] message) {
        int length = ByteBuffer.wrap(message).getInt();
        String header = new String(message, Integer.BYTES, length, StandardCharsets.UTF_8);
        assertEquals(List.of(), SCHEMA.validate(header, InputFormat.JSON).stream().map(Error::toString).toList(),
            header);
        assertFalse(SCHEMA.validate(header.replaceFirst("\\{", "{\"other\":1,"), InputFormat.JSON).isEmpty());
        assertTrue(length <= WireMessage.LONGEST_HEADER && message.length <= WireMessage.LONGEST);
        String type = WireMessage.read(message, "m").header().text("type");
        types.add(type);
        return type;
    }

    /** The next message of the league, which is checked. */
    private byte[] heard(BrokerClient client) throws BrokenException {
        byte[] bytes = listen(client);
        checked(bytes);
        return bytes;
    }

    private static byte[] hello(String bits) {
        return WireMessage.bytes(new HeaderText().put("type", "hello").put("version", "1").put("bits", bits)
            .put("machine", "a pen").put("slots", 1));
    }

    @Test
    void allThatIsSaidIsAsTheSchemaSays() throws Exception {
        make("league");
        WorkerToken token = token("league", "pen");
        Map<String, byte[]> bundles = new HashMap<>();
        // So many games that the league has not played them itself before somebody joins.
        CompletableFuture<String> run = serve("league", 300, "--quiet");
        byte[] welcome;
        byte[] job;
        try (BrokerClient client = client(token)) {
            client.say(hello("0123456789abcdef"));
            assertEquals("refused", WireMessage.read(heard(client), "m").header().text("type"));
            client.say(hello(RungLaw.WHOLE_LADDER));
            welcome = heard(client);
            try (BrokerClient.Taker taker = client.taker(List.of())) {
                job = taker.take(60_000);
                checked(job);
                GameJob.Game game = GameJob.read(job, "m", Bundle.LARGEST).games().get(0);
                for (GameJob.Seat seat : game.seats()) {
                    client.say(WireMessage.bytes(new HeaderText().put("type", "fetch").put("bundle", seat.bundle())
                        .put("from", 0)));
                    bundles.put(seat.bundle(), heard(client));
                }
            }
        }
        port = FreePort.next();                        // the league waits for other workers for some seconds
        speak(token, welcome, job, bundles);
        run.get();
        assertEquals(Set.of("hello", "fetch", "result", "unfit", "differs", "bye", "welcome", "refused", "bundle",
            "job"), types);
    }

    /** Messages of a real worker, in three joinings: to a bot that it cannot unpack, to a game, and to other rules. */
    private void speak(WorkerToken token, byte[] welcome, byte[] job, Map<String, byte[]> bundles) throws Exception {
        LeagueFolder league = new LeagueFolder(folder.resolve("league"));
        WorkerList list = WorkerList.read(league);
        String text = new String(welcome, StandardCharsets.ISO_8859_1);
        byte[] others = text.replaceFirst("\"rules\":\"[0-9a-f]{16}\"", "\"rules\":\"0123456789abcdef\"")
            .getBytes(StandardCharsets.ISO_8859_1);
        try (LeagueBroker broker = new LeagueBroker(new InetSocketAddress("127.0.0.1", port), new BrokerKey(league),
                List.of("pen"), list::admits)) {
            for (byte[] greeting : List.of(welcome, others)) {
                List<String> told = new ArrayList<>();
                Worker worker = new Worker(new Worker.Options("127.0.0.1", port, token, 1, 3, Long.MAX_VALUE,
                    () -> Isolation.OFF, folder.resolve("bundles"), Platform.here(), "2", "a machine"), Games.types(),
                    told::add);
                CompletableFuture<String> playing = CompletableFuture.supplyAsync(() -> played(worker));
                answer(broker, greeting, job, bundles, playing);
                String end = playing.get();
                if (greeting == others) {
                    assertTrue(end.startsWith("found Steward development (results 0123456789abcdef) in the league and "
                        + "Steward 2 (results ") && end.endsWith("here, expected versions that compute the same"), end);
                } else {
                    assertEquals("3", end, told::toString);
                }
            }
        }
    }

    private static String played(Worker worker) {
        try {
            worker.play();
            return Long.toString(worker.played());
        } catch (InputException | Worker.RefusedException refused) {
            return refused.getMessage();
        } catch (InterruptedException end) {
            return "interrupted";
        }
    }

    private void answer(LeagueBroker broker, byte[] welcome, byte[] job, Map<String, byte[]> bundles,
                        CompletableFuture<String> playing) throws InterruptedException {
        String none = "0".repeat(64);
        boolean last = false;
        while (!last && !playing.isDone()) {
            LeagueBroker.Report report = broker.next(200);
            if (report == null) {
                continue;
            }
            assertEquals("pen", report.worker());
            String type = checked(report.bytes());
            last = type.equals("bye") || type.equals("differs");
            WorkerWord word = WorkerWord.read(report.bytes(), "m", Bundle.LARGEST);
            if (word instanceof WorkerWord.Hello) {
                broker.tell("pen", welcome);
                broker.offer("none", Set.of(none), new GameJob(none.substring(32), List.of(new GameJob.Game(1,
                    List.of(new GameJob.Seat("n", none, 1, null))))).bytes());
            } else if (word instanceof WorkerWord.Fetch fetch) {
                byte[] known = bundles.get(fetch.bundle());
                broker.tell("pen", known != null ? known : WireMessage.bytes(new HeaderText().put("type", "bundle")
                    .put("bundle", none).put("from", 0).put("known", true), new byte[1]));
            } else if (word instanceof WorkerWord.Unfit) {
                GameJob one = GameJob.read(job, "m", Bundle.LARGEST);
                byte[] five = new GameJob(one.id(), Collections.nCopies(5, one.games().get(0))).bytes();
                checked(five);
                broker.offer("a job", Set.of(), five);
            } else if (word instanceof WorkerWord.Result result) {
                assertEquals(3, result.games().size(), "it was to play three games, and five were offered");
            }
        }
    }
}
