package steward.machines.broker;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.nio.file.Path;
import java.security.SecureRandom;
import java.util.HashMap;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.apache.activemq.artemis.api.core.ActiveMQException;
import org.apache.activemq.artemis.api.core.Message;
import org.apache.activemq.artemis.api.core.QueueConfiguration;
import org.apache.activemq.artemis.api.core.RoutingType;
import org.apache.activemq.artemis.api.core.SimpleString;
import org.apache.activemq.artemis.api.core.TransportConfiguration;
import org.apache.activemq.artemis.api.core.client.ActiveMQClient;
import org.apache.activemq.artemis.api.core.client.ClientConsumer;
import org.apache.activemq.artemis.api.core.client.ClientMessage;
import org.apache.activemq.artemis.api.core.client.ClientProducer;
import org.apache.activemq.artemis.api.core.client.ClientSession;
import org.apache.activemq.artemis.api.core.client.ClientSessionFactory;
import org.apache.activemq.artemis.api.core.client.ServerLocator;
import org.apache.activemq.artemis.core.config.Configuration;
import org.apache.activemq.artemis.core.config.impl.ConfigurationImpl;
import org.apache.activemq.artemis.core.filter.impl.FilterImpl;
import org.apache.activemq.artemis.core.remoting.impl.invm.InVMAcceptorFactory;
import org.apache.activemq.artemis.core.remoting.impl.invm.InVMConnectorFactory;
import org.apache.activemq.artemis.core.remoting.impl.netty.TransportConstants;
import org.apache.activemq.artemis.core.server.Queue;
import org.apache.activemq.artemis.core.server.ServerSession;
import org.apache.activemq.artemis.core.server.impl.ActiveMQServerImpl;
import org.apache.activemq.artemis.core.settings.impl.AddressFullMessagePolicy;
import org.apache.activemq.artemis.core.settings.impl.AddressSettings;
import steward.files.InputException;
import steward.machines.token.BrokerKey;
import steward.machines.wire.WireMessage;

/**
 * Message broker in a league's process. It keeps nothing on disk: the league's database is the truth, and games that
 * are not stored there are offered again. Only TLS 1.3 is spoken. The sender of a message is set by the broker, never
 * by the message. A client that sends or requests more than fits gets an error; nobody waits for room, since one worker
 * could occupy it for ever.
 */
public final class LeagueBroker implements AutoCloseable {

    /**
     * Time without a sign of life after which a worker's connection is closed and its jobs go to others, in ms. It is
     * kept by the acceptor: Artemis would apply it to the league's own connection, too, which is silent for minutes
     * while long games are played.
     */
    static final long TTL_MS = 10_000;
    private static final String LEAGUE = "the league";
    /** Bytes that may wait in a queue: a quarter of the heap at most. */
    private static final long MOST_WAITING = Math.min(256L << 20, Runtime.getRuntime().maxMemory() / 4);
    /** Bytes of one worker's reports that may wait: a longest one, or a quarter of all. */
    static final long QUOTA = Math.max(WireMessage.LONGEST + (1 << 16), MOST_WAITING / 4);
    private static final int CONNECTIONS = 2000;

    final ActiveMQServerImpl server;                   // a test stops it half-way
    private final LeasePlugin leases;
    private final WorkerSessions sessions;
    private final ServerLocator locator;
    private final ClientSessionFactory factory;
    private final ClientSession sending;
    private final ClientProducer producer;
    private final ClientSession receiving;
    private final ClientConsumer reports;

    /**
     * A worker's message.
     *
     * @param worker its name, as the broker knows it
     */
    public record Report(String worker, byte[] bytes) { }

    /**
     * Starts.
     *
     * @param address   to listen at
     * @param workers   whom there may be a queue for
     * @param admission of them, and of others that come with an invitation
     * @throws InputException if the port is taken, or nothing can listen there
     */
    public LeagueBroker(InetSocketAddress address, BrokerKey key, Iterable<String> workers, Admission admission) {
        this(address, key, workers, admission, QUOTA);
    }

    /** @param quota bytes of one worker's reports that may wait */
    LeagueBroker(InetSocketAddress address, BrokerKey key, Iterable<String> workers, Admission admission, long quota) {
        refuseTaken(address);
        leases = new LeasePlugin(admission);
        sessions = new WorkerSessions(quota);
        byte[] random = new byte[32];
        new SecureRandom().nextBytes(random);
        String secret = HexFormat.of().formatHex(random);
        int id = new SecureRandom().nextInt(Integer.MAX_VALUE);
        server = new ActiveMQServerImpl(configuration(address, key, id), null,
            new BrokerSecurity(LEAGUE, secret, opening(admission)));
        server.registerBrokerPlugin(leases);
        server.registerBrokerPlugin(sessions);
        try {
            server.start();
            if (!server.getRemotingService().isStarted() || server.getRemotingService().getAcceptor("workers") == null
                || !server.getRemotingService().getAcceptor("workers").isStarted()) {
                throw new InputException("serve", "nothing can listen at " + address);
            }
            locator = ActiveMQClient.createServerLocatorWithoutHA(new TransportConfiguration(
                InVMConnectorFactory.class.getName(), Map.of("serverId", Integer.toString(id))));
            locator.setMinLargeMessageSize(Integer.MAX_VALUE);
            factory = locator.createSessionFactory();
            sending = factory.createSession(LEAGUE, secret, false, true, true, false, 0);
            producer = sending.createProducer();
            receiving = factory.createSession(LEAGUE, secret, false, true, true, true, 0);
            reports = receiving.createConsumer(Queues.REPORTS);
            receiving.start();
            for (String worker : workers) {
                open(worker);
            }
        } catch (InputException refused) {
            stop();
            throw refused;
        } catch (Exception problem) {
            stop();
            throw new InputException("serve", "the broker cannot be started: " + problem.getMessage());
        }
    }

    /** Returns an admission that makes the queue of a worker that has just been added or taken in. */
    private Admission opening(Admission admission) {
        return new Admission() {
            @Override
            public boolean admits(String worker, String secret) {
                boolean admits = admission.admits(worker, secret);
                if (admits) {
                    open(worker);
                }
                return admits;
            }

            @Override
            public String enrol(String worker, String secret, String invitation) {
                String refusal = admission.enrol(worker, secret, invitation);
                if (refusal == null) {
                    open(worker);
                }
                return refusal;
            }
        };
    }

    /** Artemis would only log that. */
    private static void refuseTaken(InetSocketAddress address) {
        if (address.isUnresolved()) {
            throw new InputException("serve", "found the unknown host '" + address.getHostString()
                + "', expected one of this machine");
        }
        try (ServerSocket trial = new ServerSocket()) {
            trial.setReuseAddress(true);
            trial.bind(address);
        } catch (java.io.IOException problem) {
            throw new InputException("serve", "nothing can listen at " + address.getHostString() + ":"
                + address.getPort() + ": " + problem.getMessage() + "; another HOST:PORT may be free");
        }
    }

    private static Configuration configuration(InetSocketAddress address, BrokerKey key, int id) {
        Path folder = key.store().getParent();
        Map<String, Object> tls = new HashMap<>();
        InetAddress host = address.getAddress();
        tls.put(TransportConstants.HOST_PROP_NAME, host.getHostAddress());
        tls.put(TransportConstants.PORT_PROP_NAME, Integer.toString(address.getPort()));
        tls.put(TransportConstants.SSL_ENABLED_PROP_NAME, "true");
        tls.put(TransportConstants.KEYSTORE_PATH_PROP_NAME, key.store().toAbsolutePath().toString());
        tls.put(TransportConstants.KEYSTORE_PASSWORD_PROP_NAME, key.password());
        tls.put(TransportConstants.KEYSTORE_TYPE_PROP_NAME, "PKCS12");
        tls.put(TransportConstants.ENABLED_PROTOCOLS_PROP_NAME, "TLSv1.3");
        tls.put(TransportConstants.PROTOCOLS_PROP_NAME, "CORE");
        tls.put(TransportConstants.USE_EPOLL_PROP_NAME, "false");
        tls.put(TransportConstants.USE_KQUEUE_PROP_NAME, "false");
        tls.put(TransportConstants.CONNECTIONS_ALLOWED, Integer.toString(CONNECTIONS));
        AddressSettings settings = new AddressSettings().setAutoCreateAddresses(false).setAutoCreateQueues(false)
            .setMaxSizeBytes(MOST_WAITING).setAddressFullMessagePolicy(AddressFullMessagePolicy.FAIL)
            .setMaxDeliveryAttempts(-1).setRedeliveryDelay(0);
        Configuration configuration = new ConfigurationImpl().setName("steward").setPersistenceEnabled(false)
            .setSecurityEnabled(true).setJMXManagementEnabled(false).setPopulateValidatedUser(true)
            .setSecurityInvalidationInterval(0).setMaxDiskUsage(-1).setGracefulShutdownEnabled(false)
            .setJournalDirectory(folder.resolve("none/journal").toString())
            .setBindingsDirectory(folder.resolve("none/bindings").toString())
            .setPagingDirectory(folder.resolve("none/paging").toString())
            .setLargeMessagesDirectory(folder.resolve("none/large").toString())
            .addAddressSetting("#", settings)
            .addAcceptorConfiguration(new TransportConfiguration(InVMAcceptorFactory.class.getName(),
                Map.of("serverId", Integer.toString(id)), "inside"))
            .addAcceptorConfiguration(new TransportConfiguration(GuardedAcceptorFactory.class.getName(), tls,
                "workers"));
        for (String queue : List.of(Queues.JOBS, Queues.REPORTS)) {
            configuration.addQueueConfiguration(queue(queue));
        }
        return configuration;
    }

    private static QueueConfiguration queue(String name) {
        return QueueConfiguration.of(name).setAddress(name).setRoutingType(RoutingType.ANYCAST).setDurable(false);
    }

    /** Makes the queue of a worker, if it is not there. One connection at a time may read it. */
    public synchronized void open(String worker) {
        try {
            if (server.locateQueue(SimpleString.of(Queues.TO + worker)) == null) {
                server.createQueue(queue(Queues.TO + worker).setMaxConsumers(1).setAutoCreateAddress(true));
            }
        } catch (Exception problem) {
            throw new InputException("the broker refuses a queue for " + worker + ": " + problem.getMessage());
        }
    }

    public void tell(String worker, byte[] message) {
        send(Queues.TO + worker, message, null, Set.of());
    }

    /**
     * Offers a job to all workers.
     *
     * @param bundles the bots that it needs, by their hashes
     */
    public void offer(String job, Set<String> bundles, byte[] message) {
        send(Queues.JOBS, message, job, bundles);
    }

    private synchronized void send(String queue, byte[] bytes, String job, Set<String> bundles) {
        try {
            ClientMessage message = sending.createMessage(false);
            message.getBodyBuffer().writeBytes(bytes);
            if (job != null) {
                message.putStringProperty(Queues.JOB, job);
                bundles.forEach(bundle -> message.putBooleanProperty(Queues.NEEDS + bundle, true));
            }
            producer.send(queue, message);
        } catch (ActiveMQException problem) {
            throw new InputException("the broker refuses a message: " + problem.getMessage());
        }
    }

    /** Returns a worker's next message. @return {@code null} if nobody says anything for so long */
    public Report next(long waitMs) throws InterruptedException {
        try {
            ClientMessage message = reports.receive(waitMs);
            if (message == null) {
                return null;
            }
            String worker = message.getStringProperty(Message.HDR_VALIDATED_USER);
            int size = Math.min(message.getBodySize(), WireMessage.LONGEST + 1);
            byte[] bytes = new byte[size];
            message.getBodyBuffer().readBytes(bytes);
            if (worker != null) {
                sessions.read(worker, message.getEncodeSize());
            }
            return new Report(worker == null ? "" : worker, bytes);
        } catch (ActiveMQException problem) {
            if (problem.getCause() instanceof InterruptedException) {
                throw (InterruptedException) problem.getCause();
            }
            return null;
        }
    }

    /** Offers what waits once more to workers that were refused. */
    public void offerAgain() {
        Queue jobs = server.locateQueue(SimpleString.of(Queues.JOBS));
        jobs.resetAllIterators();                      // they have passed the jobs that they were refused
        jobs.deliverAsync();
    }

    /** Who has a job, or {@code null}. */
    public String holder(String job) {
        return leases.holder(job);
    }

    /** For how long it has had it, in nanoseconds; 0 if nobody has. */
    public long heldNanos(String job) {
        Long since = leases.since(job);
        return since == null ? 0 : System.nanoTime() - since;
    }

    /** The job is over, or taken away. */
    public void forget(String job) {
        leases.forget(job);
    }

    /** Offers a job no more; whoever has it may go on. */
    public void withdraw(String job) {
        delete(Queues.JOBS, Queues.JOB + " = '" + job + "'");
    }

    /** The workers that are connected, by name. */
    public Set<String> connected() {
        return server.getSessions().stream().map(session -> String.valueOf(session.getUsername()))
            .filter(worker -> !worker.equals(LEAGUE)).collect(Collectors.toCollection(TreeSet::new));
    }

    /** Closes the connections of a worker and removes what waits of it and for it; its jobs go to others. */
    public void disconnect(String worker) {
        for (ServerSession session : server.getSessions()) {
            if (worker.equals(session.getUsername())) {
                session.getRemotingConnection().fail(new ActiveMQException("revoked"));
            }
        }
        delete(Queues.REPORTS, Message.HDR_VALIDATED_USER + " = '" + worker + "'");
        delete(Queues.TO + worker, null);
    }

    private void delete(String queue, String filter) {
        try {
            server.locateQueue(SimpleString.of(queue)).deleteMatchingReferences(FilterImpl.createFilter(filter));
        } catch (Exception stays) {
            return;                                    // it is bounded, and of no consequence
        }
    }

    private void stop() {
        try {
            server.stop(false, true);
        } catch (Exception gone) {
            return;
        }
    }

    @Override
    public void close() {
        try {
            locator.close();
        } finally {
            stop();
        }
    }
}
