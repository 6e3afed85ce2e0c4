package steward.machines.broker;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.UnknownHostException;
import java.security.GeneralSecurityException;
import java.util.HashMap;
import java.util.Map;
import javax.net.ssl.SSLException;
import javax.net.ssl.SSLSocket;
import org.apache.activemq.artemis.api.core.ActiveMQException;
import org.apache.activemq.artemis.api.core.ActiveMQExceptionType;
import org.apache.activemq.artemis.api.core.TransportConfiguration;
import org.apache.activemq.artemis.api.core.client.ActiveMQClient;
import org.apache.activemq.artemis.api.core.client.ClientConsumer;
import org.apache.activemq.artemis.api.core.client.ClientMessage;
import org.apache.activemq.artemis.api.core.client.ClientProducer;
import org.apache.activemq.artemis.api.core.client.ClientSession;
import org.apache.activemq.artemis.api.core.client.ClientSessionFactory;
import org.apache.activemq.artemis.api.core.client.ServerLocator;
import org.apache.activemq.artemis.core.remoting.impl.netty.NettyConnectorFactory;
import org.apache.activemq.artemis.core.remoting.impl.netty.TransportConstants;
import org.apache.activemq.artemis.spi.core.protocol.RemotingConnection;
import steward.machines.token.WorkerToken;
import steward.machines.wire.WireMessage;

/** A worker's connection to a league's broker. A broken connection is not repaired: the worker makes another one. */
public final class BrokerClient implements AutoCloseable {

    /** How the error begins that says that the broker has another key. */
    static final String OTHER_KEY = "the broker has another key than the token says";
    /** Signs of life within the time after which silence ends a connection. */
    private static final int SIGNS = 4;
    private static final long CALL_MS = 20_000;
    private static final int CONNECT_MS = 10_000;
    /** Artemis' number of the refusal by a broker that is not up; it has the type of our own refusals. */
    private static final String NOT_STARTED = "AMQ229034";

    private final WorkerToken token;
    private final String process;
    private final ServerLocator locator;
    private final ClientSessionFactory factory;
    private final ClientSession session;
    private final ClientSession listening;
    private final ClientProducer producer;
    private final ClientConsumer told;

    /** Failure of a connection: it could not be made, or it broke. */
    public static final class BrokenException extends Exception {

        private final boolean refused;

        /** @param refused see {@link #isRefused} */
        public BrokenException(String message, boolean refused) {
            super(message);
            this.refused = refused;
        }

        /** True if it makes no sense to try again: the token is not good here, or the broker is another. */
        public boolean isRefused() {
            return refused;
        }
    }

    /**
     * Connects.
     *
     * @param process unlike that of any other worker: of those with one token the broker keeps the newest
     * @throws BrokenException if there is no connection
     */
    public BrokerClient(String host, int port, WorkerToken token, String process) throws BrokenException {
        this.token = token;
        this.process = process;
        Map<String, Object> options = new HashMap<>();
        options.put(TransportConstants.HOST_PROP_NAME, host);
        options.put(TransportConstants.PORT_PROP_NAME, Integer.toString(port));
        options.put(TransportConstants.SSL_ENABLED_PROP_NAME, "true");
        options.put(TransportConstants.SSL_CONTEXT_PROP_NAME, PinnedContextFactory.PIN + token.broker());
        options.put(TransportConstants.VERIFY_HOST_PROP_NAME, "false");
        options.put(TransportConstants.ENABLED_PROTOCOLS_PROP_NAME, "TLSv1.3");
        options.put(TransportConstants.USE_EPOLL_PROP_NAME, "false");
        options.put(TransportConstants.USE_KQUEUE_PROP_NAME, "false");
        locator = ActiveMQClient.createServerLocatorWithoutHA(new TransportConfiguration(
            NettyConnectorFactory.class.getName(), options));
        locator.setReconnectAttempts(0).setInitialConnectAttempts(1).setConsumerWindowSize(0)
            .setConnectionTTL(LeagueBroker.TTL_MS).setClientFailureCheckPeriod(LeagueBroker.TTL_MS / SIGNS)
            .setMinLargeMessageSize(Integer.MAX_VALUE).setCallTimeout(CALL_MS).setBlockOnNonDurableSend(false)
            .setProducerWindowSize(-1)
            .setUseGlobalPools(false);
        ClientSessionFactory made;
        try {
            made = locator.createSessionFactory();
        } catch (Exception problem) {
            locator.close();
            throw unreachable(host, port, token);
        }
        try {
            factory = made;
            session = session(false);
            producer = session.createProducer(Queues.REPORTS);
            listening = session(true);
            told = listening.createConsumer(Queues.TO + token.worker());
            listening.start();
        } catch (ActiveMQException problem) {
            locator.close();
            throw broken(problem);
        }
    }

    /** Artemis says that it cannot connect, and not why: this looks. */
    private static BrokenException unreachable(String host, int port, WorkerToken token) {
        String where = host + ":" + port + ": ";
        try (SSLSocket socket = (SSLSocket) PinnedContextFactory.context(token.broker()).getSocketFactory()
                .createSocket()) {
            socket.connect(new InetSocketAddress(host, port), CONNECT_MS);
            socket.setSoTimeout(CONNECT_MS);
            socket.startHandshake();
            return new BrokenException(where + "the broker closes the connection", false);
        } catch (UnknownHostException unknown) {
            return new BrokenException(where + "found an unknown host, expected that of a league", true);
        } catch (SSLException problem) {
            for (Throwable cause = problem; cause != null; cause = cause.getCause()) {
                if (String.valueOf(cause.getMessage()).startsWith(OTHER_KEY)) {
                    return new BrokenException(where + cause.getMessage(), true);
                }
            }
            return new BrokenException(where + "found no broker of a league, expected one that speaks TLS 1.3: "
                + problem.getMessage(), false);
        } catch (IOException | GeneralSecurityException problem) {
            return new BrokenException(where + problem.getMessage(), false);
        }
    }

    private ClientSession session(boolean alone) throws ActiveMQException {
        return factory.createSession(token.worker(), token.secret() + BrokerSecurity.MARK
            + (token.invitation() == null ? "" : token.invitation()) + BrokerSecurity.MARK + process, false, alone,
            alone, false, 0);
    }

    private static BrokenException broken(ActiveMQException problem) {
        ActiveMQExceptionType type = problem.getType();
        if (type == ActiveMQExceptionType.SECURITY_EXCEPTION) {
            return new BrokenException("the league refuses the token: it is wrong or revoked", true);
        }
        if (String.valueOf(problem.getMessage()).startsWith(NOT_STARTED)) {
            return new BrokenException("the league is just starting or ending", false);
        }
        return new BrokenException(inOurWords(type, problem),
            type == ActiveMQExceptionType.SESSION_CREATION_REJECTED);
    }

    /** Artemis begins its messages with numbers of its own. */
    private static String inOurWords(ActiveMQExceptionType type, ActiveMQException problem) {
        return switch (type) {
            case OBJECT_CLOSED, NOT_CONNECTED, DISCONNECTED, CONNECTION_TIMEDOUT, UNBLOCKED ->
                "the connection is closed";
            case ADDRESS_FULL -> "too much waits at the league";
            case MAX_CONSUMER_LIMIT_EXCEEDED -> "the league still holds the connection before this one";
            default -> String.valueOf(problem.getMessage()).replaceFirst("^AMQ[0-9]+: *", "");
        };
    }

    /** Says something to the league. */
    public synchronized void say(byte[] bytes) throws BrokenException {
        try {
            ClientMessage message = session.createMessage(false);
            message.getBodyBuffer().writeBytes(bytes);
            producer.send(message);
            session.commit();
        } catch (ActiveMQException problem) {
            throw broken(problem);
        }
    }

    /** Returns the league's next message to this worker; {@code null} if nothing comes for so long. */
    public byte[] listen(long waitMs) throws BrokenException {
        try {
            ClientMessage message = told.receive(waitMs);
            if (message == null) {
                RemotingConnection connection = listening.isClosed() ? null : factory.getConnection();
                if (connection == null || connection.isDestroyed()) {
                    throw new BrokenException("the connection is closed", false);
                }
                return null;
            }
            byte[] bytes = bytes(message);
            message.acknowledge();
            return bytes;
        } catch (IllegalStateException gone) {         // the factory has been closed meanwhile
            throw new BrokenException("the connection is closed", false);
        } catch (ActiveMQException problem) {
            throw broken(problem);
        }
    }

    private static byte[] bytes(ClientMessage message) {
        byte[] bytes = new byte[Math.min(message.getBodySize(), WireMessage.LONGEST + 1)];
        message.getBodyBuffer().readBytes(bytes);
        return bytes;
    }

    /** Takes jobs one by one; a job that is not finished when the connection ends goes to another worker. */
    public Taker taker(Iterable<String> withoutBundles) throws BrokenException {
        try {
            return new Taker(session(false), Queues.without(withoutBundles));
        } catch (ActiveMQException problem) {
            throw broken(problem);
        }
    }

    /** One place for a game. Used by one thread. */
    public static final class Taker implements AutoCloseable {

        private final ClientSession session;
        private final ClientConsumer jobs;
        private final ClientProducer reports;
        private ClientMessage taken;

        Taker(ClientSession session, String filter) throws ActiveMQException {
            this.session = session;
            jobs = filter == null ? session.createConsumer(Queues.JOBS) : session.createConsumer(Queues.JOBS, filter);
            reports = session.createProducer(Queues.REPORTS);
            session.start();
        }

        /** The next job, or {@code null} if there is none for so long. */
        public byte[] take(long waitMs) throws BrokenException {
            try {
                taken = jobs.receive(waitMs);
                if (taken == null && session.isClosed()) {
                    throw new BrokenException("the connection is closed", false);
                }
                return taken == null ? null : bytes(taken);
            } catch (ActiveMQException problem) {
                throw broken(problem);
            }
        }

        /** Finishes the job with what came of it, both or neither. */
        public void finish(byte[] report) throws BrokenException {
            try {
                ClientMessage message = session.createMessage(false);
                message.getBodyBuffer().writeBytes(report);
                reports.send(message);
                taken.acknowledge();
                session.commit();
            } catch (ActiveMQException problem) {
                throw broken(problem);
            }
        }

        /** Gives the job back. */
        @Override
        public void close() {
            try {
                session.close();
            } catch (ActiveMQException gone) {
                return;
            }
        }
    }

    @Override
    public void close() {
        locator.close();
    }
}
