package steward.machines.broker;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import org.apache.activemq.artemis.api.core.ActiveMQException;
import org.apache.activemq.artemis.api.core.ActiveMQExceptionType;
import org.apache.activemq.artemis.api.core.QueueConfiguration;
import org.apache.activemq.artemis.api.core.RoutingType;
import org.apache.activemq.artemis.api.core.client.ClientMessage;
import org.apache.activemq.artemis.api.core.client.ClientProducer;
import org.apache.activemq.artemis.api.core.client.ClientSession;
import org.apache.activemq.artemis.api.core.client.ClientSessionFactory;
import org.apache.activemq.artemis.api.core.client.ServerLocator;
import org.apache.activemq.artemis.core.server.ActivateCallback;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.function.Executable;
import org.junit.jupiter.api.function.ThrowingConsumer;
import org.junit.jupiter.api.io.TempDir;
import steward.machines.broker.BrokerClient.BrokenException;

/** Rights of a worker with a good token, tried with a client of Artemis that is not ours. */
@Tag("process")
@Tag("slow")
@Timeout(120)
class BrokerRightsTest {

    @TempDir
    private Path folder;

    private static void refused(Executable what) {
        ActiveMQException problem = assertThrows(ActiveMQException.class, what);
        assertEquals(ActiveMQExceptionType.SECURITY_EXCEPTION, problem.getType(), problem.getMessage());
    }

    private static void refused(ServedBroker served, ThrowingConsumer<ClientSession> what) throws Exception {
        try (ServerLocator locator = served.locator("one");
             ClientSessionFactory factory = locator.createSessionFactory()) {
            ClientSession session = factory.createSession("one", served.token("one").secret(), false, true, true, false,
                0);
            ActiveMQException problem = assertThrows(ActiveMQException.class, () -> what.accept(session));
            assertNotEquals(ActiveMQExceptionType.CONNECTION_TIMEDOUT, problem.getType(), "it was not ignored");
        }
    }

    @Test
    void aWorkerMayTakeJobsAndReportAndNothingElse() throws Exception {
        try (ServedBroker served = new ServedBroker(folder, "one", "two");
             ServerLocator locator = served.locator("one");
             ClientSessionFactory factory = locator.createSessionFactory()) {
            String secret = served.token("one").secret();
            refused(() -> factory.createSession("one", "x".repeat(43), false, true, true, false, 0));
            refused(() -> factory.createSession("two", secret, false, true, true, false, 0));
            refused(() -> factory.createSession("the league", secret, false, true, true, false, 0));
            ClientSession session = factory.createSession("one", secret, false, true, true, false, 0);
            session.createConsumer(Queues.JOBS).close();
            session.createConsumer(Queues.TO + "one").close();
            refused(() -> session.createConsumer(Queues.REPORTS));
            refused(() -> session.createConsumer(Queues.REPORTS, true));
            refused(() -> session.createConsumer(Queues.TO + "two"));
            refused(() -> send(session, Queues.JOBS));
            refused(() -> send(session, Queues.TO + "two"));
            refused(() -> send(session, "activemq.management"));
            send(session, Queues.REPORTS);
            assertEquals("one", served.report().get(0), "the broker says who it was");
        }
    }

    /** Types of packets and properties of messages that no worker needs; each of them is refused. */
    @Test
    void whatTheProtocolDoesNotNameIsRefused() throws Exception {
        try (ServedBroker served = new ServedBroker(folder, "one", "two")) {
            refused(served, session -> session.createQueue(QueueConfiguration.of("mine")
                .setRoutingType(RoutingType.ANYCAST)));
            refused(served, session -> session.deleteQueue(Queues.JOBS));
            refused(served, session -> send(session, message -> message.putStringProperty("_AMQ_VALIDATED_USER",
                "two")));
            refused(served, session -> send(session, message -> message.putLongProperty("_AMQ_SCHED_DELIVERY",
                Long.MAX_VALUE)));
            refused(served, session -> send(session, message -> message.setExpiration(1)));
            refused(served, session -> send(session, message -> message.putStringProperty("mine", "x")));
            refused(served, session -> session.createConsumer(Queues.JOBS, "job LIKE '%a%a%a%'"));
            try (BrokerClient honest = served.client("two", "p")) {
                honest.say("honest".getBytes(StandardCharsets.UTF_8));
                assertEquals(List.of("two", "honest"), served.report(), "nothing of the others waits before it");
            }
        }
    }

    /** While it stops, a broker answers as one that refuses; but the league may be served again soon. */
    @Test
    void aWorkerThatComesWhileTheBrokerEndsMayTryAgain() throws Exception {
        CountDownLatch ending = new CountDownLatch(1);
        CountDownLatch refused = new CountDownLatch(1);
        try (ServedBroker served = new ServedBroker(folder, "one")) {
            served.broker.server.registerActivateCallback(new ActivateCallback() {
                @Override
                public void preDeActivate() {
                    ending.countDown();
                    try {
                        refused.await(60, TimeUnit.SECONDS);
                    } catch (InterruptedException end) {
                        Thread.currentThread().interrupt();
                    }
                }
            });
            Thread closing = new Thread(served::close);
            closing.start();
            try {
                assertTrue(ending.await(60, TimeUnit.SECONDS));
                BrokenException problem = assertThrows(BrokenException.class, () -> served.client("one", "p"));
                assertEquals("the league is just starting or ending", problem.getMessage());
                assertFalse(problem.isRefused());
            } finally {
                refused.countDown();
                closing.join();
            }
        }
    }

    private static void send(ClientSession session, String address) throws ActiveMQException {
        try (ClientProducer producer = session.createProducer(address)) {
            producer.send(session.createMessage(false));
        }
    }

    private static void send(ClientSession session, Consumer<ClientMessage> change) throws ActiveMQException {
        try (ClientProducer producer = session.createProducer(Queues.REPORTS)) {
            ClientMessage message = session.createMessage(false);
            change.accept(message);
            producer.send(message);
        }
    }
}
