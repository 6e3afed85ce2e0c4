package steward.machines.broker;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.apache.activemq.artemis.api.core.ActiveMQException;
import org.apache.activemq.artemis.api.core.ActiveMQExceptionType;
import org.apache.activemq.artemis.api.core.QueueConfiguration;
import org.apache.activemq.artemis.api.core.RoutingType;
import org.apache.activemq.artemis.api.core.TransportConfiguration;
import org.apache.activemq.artemis.api.core.client.ActiveMQClient;
import org.apache.activemq.artemis.api.core.client.ClientProducer;
import org.apache.activemq.artemis.api.core.client.ClientSession;
import org.apache.activemq.artemis.api.core.client.ClientSessionFactory;
import org.apache.activemq.artemis.api.core.client.ServerLocator;
import org.apache.activemq.artemis.core.remoting.impl.netty.NettyConnectorFactory;
import org.apache.activemq.artemis.core.remoting.impl.netty.TransportConstants;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.function.Executable;
import org.junit.jupiter.api.io.TempDir;
import steward.league.LeagueFolder;
import steward.machines.token.BrokerKey;
import steward.machines.token.WorkerList;
import steward.machines.token.WorkerToken;

/** What a worker with a good token may not do, with a client of Artemis that is not ours. */
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

    @Test
    void aWorkerMayTakeJobsAndReportAndNothingElse() throws Exception {
        LeagueFolder league = new LeagueFolder(Files.createDirectory(folder.resolve("league")));
        WorkerList.add(league, "one", folder.resolve("one.token"));
        WorkerList.add(league, "two", folder.resolve("two.token"));
        WorkerToken token = WorkerToken.read(folder.resolve("one.token"));
        int port;
        try (ServerSocket free = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            port = free.getLocalPort();
        }
        WorkerList list = WorkerList.read(league);
        Map<String, Object> options = new HashMap<>();
        options.put(TransportConstants.HOST_PROP_NAME, "127.0.0.1");
        options.put(TransportConstants.PORT_PROP_NAME, Integer.toString(port));
        options.put(TransportConstants.SSL_ENABLED_PROP_NAME, "true");
        options.put(TransportConstants.SSL_CONTEXT_PROP_NAME, PinnedContextFactory.PIN + token.broker());
        options.put(TransportConstants.VERIFY_HOST_PROP_NAME, "false");
        try (LeagueBroker broker = new LeagueBroker(new InetSocketAddress("127.0.0.1", port), new BrokerKey(league),
                List.of("one", "two"), list::admits);
             ServerLocator locator = ActiveMQClient.createServerLocatorWithoutHA(new TransportConfiguration(
                NettyConnectorFactory.class.getName(), options));
             ClientSessionFactory factory = locator.setReconnectAttempts(0)
                .setBlockOnNonDurableSend(true).createSessionFactory()) {
            refused(() -> factory.createSession("one", "x".repeat(43), false, true, true, false, 0));
            refused(() -> factory.createSession("two", token.secret(), false, true, true, false, 0));
            refused(() -> factory.createSession("the league", token.secret(), false, true, true, false, 0));
            ClientSession session = factory.createSession("one", token.secret(), false, true, true, false, 0);
            session.createConsumer(Queues.JOBS).close();
            session.createConsumer(Queues.TO + "one").close();
            refused(() -> session.createConsumer(Queues.REPORTS));
            refused(() -> session.createConsumer(Queues.REPORTS, true));
            refused(() -> session.createConsumer(Queues.TO + "two"));
            refused(() -> session.createQueue(QueueConfiguration.of("mine").setRoutingType(RoutingType.ANYCAST)));
            refused(() -> session.deleteQueue(Queues.JOBS));
            refused(() -> send(session, Queues.JOBS));
            refused(() -> send(session, Queues.TO + "two"));
            refused(() -> send(session, "activemq.management"));
            send(session, Queues.REPORTS);
            LeagueBroker.Report report = null;
            while (report == null) {
                report = broker.next(500);
            }
            assertEquals("one", report.worker(), "the broker says who it was");
        }
    }

    /** A report that says that it comes from another worker. */
    private static void send(ClientSession session, String address) throws ActiveMQException {
        try (ClientProducer producer = session.createProducer(address)) {
            producer.send(session.createMessage(false).putStringProperty("_AMQ_VALIDATED_USER", "two"));
        }
    }
}
