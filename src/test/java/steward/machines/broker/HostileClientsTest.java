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
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.MethodOrderer;
import org.junit.jupiter.api.Order;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestMethodOrder;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.api.parallel.ResourceLock;

/** Clients that want to fill the broker's memory or keep its connections, with and without a token. */
@Tag("process")
@Tag("slow")
@Timeout(240)
@Execution(ExecutionMode.CONCURRENT)
@ResourceLock("broker under attack")                  // so its methods, which share it, run one after another
@TestMethodOrder(MethodOrderer.OrderAnnotation.class)
class HostileClientsTest {

    /** Bytes of reports that may wait. The quota of a real broker is up to 64 MiB. */
    private static final long QUOTA = 2 << 20;
    /** Part of the quota that one message takes. */
    private static final int HEAVY = 8;
    private static final int IDLE = 8;

    @TempDir
    private static Path shared;
    private static ServedBroker served;
    /** Connections that are made before all tests and do not log in. */
    private static final List<SSLSocket> STRANGERS = new ArrayList<>();

    @TempDir
    private Path folder;

    @BeforeAll
    static void serve() throws Exception {
        served = new ServedBroker(shared, QUOTA, "one", "two");
        for (int k = 0; k < IDLE; k++) {
            SSLSocket stranger = served.stranger();
            STRANGERS.add(stranger);
            if (k % 2 == 0) {
                stranger.getOutputStream().write(k % 4 == 0 ? PREAMBLE : frame(100, CREATE_SESSION));
            }
        }
    }

    @AfterAll
    static void end() throws IOException {
        for (SSLSocket stranger : STRANGERS) {
            stranger.close();
        }
        if (served != null) {
            served.close();
        }
    }

    private static void assertHonestGoesOn() throws Exception {
        assertHonestGoesOn(served);
    }

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
    @Tag("campaign")
    void aBrokerAndAWorkerThatAreSilentForLongStillHearEachOther() throws Exception {
        try (BrokerClient client = served.client("one", "p")) {
            TimeUnit.MILLISECONDS.sleep(LeagueBroker.TTL_MS * 3 / 2);
            client.say("still here".getBytes(StandardCharsets.UTF_8));
            assertEquals(List.of("one", "still here"), served.report());
        }
    }

    /** It is why silence does not end a connection: without them it would be closed before the proxy hears any. */
    @Test
    @Tag("campaign")
    void aBrokerAndAWorkerThatAreSilentGiveSignsOfLife() throws Exception {
        try (CutProxy between = new CutProxy(served.port());
             BrokerClient client = new BrokerClient("127.0.0.1", between.port(), served.token("one"), "silent")) {
            for (int sign = 0; sign < 2; sign++) {               // the first might still be of the login
                int worker = between.heardOfWorkers();
                int league = between.heardOfLeague();
                while (between.heardOfWorkers() == worker || between.heardOfLeague() == league) {
                    TimeUnit.MILLISECONDS.sleep(20);
                }
                TimeUnit.MILLISECONDS.sleep(500);
            }
            client.say("still here".getBytes(StandardCharsets.UTF_8));
            assertEquals(List.of("one", "still here"), served.report());
        }
    }

    @Test
    void strangersAreClosedBeforeTheyTakeMemory() throws Exception {
        byte[] chunk = new byte[1 << 16];
        assertClosed(served.stranger(), frame(Integer.MAX_VALUE, CREATE_SESSION), chunk);
        assertClosed(served.stranger(), frame(-1, CREATE_SESSION), chunk);
        assertClosed(served.stranger(), frame(100, (byte) 72), chunk);           // a large message before a login
        assertClosed(served.stranger(), ("POST / HTTP/1.1\r\nHost: a\r\nContent-Length: 2000000000\r\n\r\n")
            .getBytes(StandardCharsets.US_ASCII), chunk);
        assertHonestGoesOn();
    }

    @Test
    @Order(Integer.MAX_VALUE)
    void connectionsThatDoNotLogInAreClosed() throws Exception {
        assertHonestGoesOn();
        for (SSLSocket stranger : STRANGERS) {
            assertClosed(stranger, new byte[0], new byte[0]);
        }
    }

    @Test
    void aLargeMessageEndsTheConnection() throws Exception {
        try (ServerLocator locator = served.locator("one").setMinLargeMessageSize(1000);
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
            assertHonestGoesOn();
        }
    }

    @Test
    void oneTokenCannotFillTheQueueForTheOthers() throws Exception {
        assertOneTokenCannotFillTheQueue(served, QUOTA);
    }

    @Test
    @Tag("campaign")
    void oneTokenCannotFillTheQueueOfARealBroker() throws Exception {
        try (ServedBroker real = new ServedBroker(folder, "one", "two")) {
            assertOneTokenCannotFillTheQueue(real, LeagueBroker.QUOTA);
        }
    }

    /** Messages of a transaction that is never ended wait unseen; they count, too. */
    private static void assertOneTokenCannotFillTheQueue(ServedBroker broker, long quota) throws Exception {
        int size = (int) (quota / HEAVY);
        try (ServerLocator locator = broker.locator("one").setMinLargeMessageSize(Integer.MAX_VALUE)
                 .setProducerWindowSize(-1);
             ClientSessionFactory factory = locator.createSessionFactory()) {
            ClientSession session = factory.createSession("one", broker.token("one").secret(), false, false, false,
                false, 0);
            try (ClientProducer producer = session.createProducer(Queues.REPORTS)) {
                ClientMessage heavy = session.createMessage(false);
                heavy.getBodyBuffer().writeBytes(new byte[size]);
                assertThrows(ActiveMQException.class, () -> {
                    for (long sent = 0; sent <= quota; sent += size) {
                        producer.send(heavy);
                    }
                    session.commit();
                });
            }
            assertHonestGoesOn(broker);
        }
    }
}
