package steward.machines.broker;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static steward.machines.broker.HostileClients.CREATE_SESSION;
import static steward.machines.broker.HostileClients.PREAMBLE;
import static steward.machines.broker.HostileClients.frame;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import javax.net.ssl.SSLSocket;
import org.apache.activemq.artemis.api.core.ActiveMQException;
import org.apache.activemq.artemis.api.core.client.ClientMessage;
import org.apache.activemq.artemis.api.core.client.ClientProducer;
import org.apache.activemq.artemis.api.core.client.ClientSession;
import org.apache.activemq.artemis.api.core.client.ClientSessionFactory;
import org.apache.activemq.artemis.api.core.client.ServerLocator;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** Clients that want to fill the broker's memory or keep its connections, with and without a token. */
@Tag("process")
@Tag("slow")
@Timeout(240)
@Execution(ExecutionMode.CONCURRENT)
class HostileClientsTest {

    @TempDir
    private Path folder;

    private static void assertHonestGoesOn(ServedBroker served) throws Exception {
        try (BrokerClient honest = served.client("two", "honest")) {
            honest.say("here".getBytes(StandardCharsets.UTF_8));
            List<String> report = served.report();
            while (!report.get(0).equals("two")) {
                report = served.report();
            }
            assertEquals(List.of("two", "here"), report);
        }
    }

    /** Writes until the broker closes the connection. */
    private static void assertClosed(SSLSocket socket, byte[] first, byte[] then) throws IOException {
        try (socket; OutputStream out = socket.getOutputStream(); InputStream in = socket.getInputStream()) {
            out.write(first);
            for (int sent = 0; sent < 1 << 30 && then.length > 0; sent += then.length) {
                out.write(then);
            }
            assertTrue(in.read() < 0, "closed without a word");
        } catch (IOException broken) {
            assertTrue(!(broken instanceof java.net.SocketTimeoutException), () -> "it stays open: " + broken);
        }
    }

    /** The short form of what the Gradle task {@code hostileClients} does with 100 clients. */
    @Test
    void honestWorkersGoOnBesideManyThatAttack() throws Exception {
        assertHonestWorkersGoOn(12, 1);
    }

    @Test
    @Tag("campaign")
    void honestWorkersGoOnBesideMoreThatAttackForLonger() throws Exception {
        assertHonestWorkersGoOn(24, 3);
    }

    private void assertHonestWorkersGoOn(int clients, int seconds) throws Exception {
        StringBuilder said = new StringBuilder();
        assertNull(HostileClients.play(folder, clients, seconds, 256, line -> said.append(line).append('\n')),
            said::toString);
    }

    /** Long games: for minutes nobody says anything, and both connections stay. */
    @Test
    void aBrokerAndAWorkerThatAreSilentForLongStillHearEachOther() throws Exception {
        try (ServedBroker served = new ServedBroker(folder, "one"); BrokerClient client = served.client("one", "p")) {
            TimeUnit.MILLISECONDS.sleep(LeagueBroker.TTL_MS * 3 / 2);
            client.say("still here".getBytes(StandardCharsets.UTF_8));
            assertEquals(List.of("one", "still here"), served.report());
        }
    }

    @Test
    void strangersAreClosedBeforeTheyTakeMemory() throws Exception {
        try (ServedBroker served = new ServedBroker(folder, "one", "two")) {
            byte[] chunk = new byte[1 << 16];
            assertClosed(served.stranger(), frame(Integer.MAX_VALUE, CREATE_SESSION), chunk);
            assertClosed(served.stranger(), frame(-1, CREATE_SESSION), chunk);
            assertClosed(served.stranger(), frame(100, (byte) 72), chunk);       // a large message before a login
            assertClosed(served.stranger(), ("POST / HTTP/1.1\r\nHost: a\r\nContent-Length: 2000000000\r\n\r\n")
                .getBytes(StandardCharsets.US_ASCII), chunk);
            assertHonestGoesOn(served);
        }
    }

    @Test
    void connectionsThatDoNotLogInAreClosed() throws Exception {
        try (ServedBroker served = new ServedBroker(folder, "one", "two")) {
            List<SSLSocket> idle = new ArrayList<>();
            for (int k = 0; k < 20; k++) {
                idle.add(served.stranger());
                if (k % 2 == 0) {
                    idle.get(k).getOutputStream().write(k % 4 == 0 ? PREAMBLE : frame(100, CREATE_SESSION));
                }
            }
            assertHonestGoesOn(served);
            for (SSLSocket socket : idle) {
                assertClosed(socket, new byte[0], new byte[0]);
            }
        }
    }

    @Test
    void aLargeMessageEndsTheConnection() throws Exception {
        try (ServedBroker served = new ServedBroker(folder, "one", "two");
             ServerLocator locator = served.locator("one").setMinLargeMessageSize(1000);
             ClientSessionFactory factory = locator.createSessionFactory()) {
            ClientSession session = factory.createSession("one", served.token("one").secret(), false, true, true, false,
                0);
            try (ClientProducer producer = session.createProducer(Queues.REPORTS)) {
                ClientMessage endless = session.createMessage(false);
                endless.setBodyInputStream(new InputStream() {
                    @Override
                    public int read() {
                        return 'x';
                    }
                });
                assertThrows(ActiveMQException.class, () -> producer.send(endless));
            }
            assertHonestGoesOn(served);
        }
    }

    /** Messages of a transaction that is never ended wait unseen; they count, too. */
    @Test
    void oneTokenCannotFillTheQueueForTheOthers() throws Exception {
        try (ServedBroker served = new ServedBroker(folder, "one", "two");
             ServerLocator locator = served.locator("one").setMinLargeMessageSize(Integer.MAX_VALUE)
                 .setProducerWindowSize(-1);
             ClientSessionFactory factory = locator.createSessionFactory()) {
            ClientSession session = factory.createSession("one", served.token("one").secret(), false, false, false,
                false, 0);
            try (ClientProducer producer = session.createProducer(Queues.REPORTS)) {
                ClientMessage heavy = session.createMessage(false);
                heavy.getBodyBuffer().writeBytes(new byte[4 << 20]);
                assertThrows(ActiveMQException.class, () -> {
                    for (int k = 0; k < 100; k++) {
                        producer.send(heavy);
                    }
                    session.commit();
                });
            }
            assertHonestGoesOn(served);
        }
    }
}
