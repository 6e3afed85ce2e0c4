package steward.machines.broker;

import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicLong;
import java.util.regex.Pattern;
import org.apache.activemq.artemis.api.core.ActiveMQException;
import org.apache.activemq.artemis.api.core.ActiveMQExceptionType;
import org.apache.activemq.artemis.api.core.Message;
import org.apache.activemq.artemis.api.core.RoutingType;
import org.apache.activemq.artemis.api.core.SimpleString;
import org.apache.activemq.artemis.core.persistence.OperationContext;
import org.apache.activemq.artemis.core.postoffice.QueueBinding;
import org.apache.activemq.artemis.core.remoting.impl.invm.InVMConnection;
import org.apache.activemq.artemis.core.remoting.impl.netty.NettyServerConnection;
import org.apache.activemq.artemis.core.server.ServerSession;
import org.apache.activemq.artemis.core.server.plugin.ActiveMQServerPlugin;
import org.apache.activemq.artemis.core.transaction.Transaction;
import org.apache.activemq.artemis.spi.core.protocol.RemotingConnection;
import org.apache.activemq.artemis.spi.core.protocol.SessionCallback;
import steward.machines.wire.WireMessage;
import steward.machines.wire.WorkerWord;

/**
 * Plugin of Artemis with rules for the sessions of workers. A token has one connection, the newest: after a break the
 * broker may hold the old one for seconds, which must not keep its own worker out. A process that another one has
 * replaced is refused while the other is connected. A report must be a plain message: Artemis obeys many properties,
 * one of which lets a message wait for years in the queue. No worker may fill the queue of reports for the others.
 */
final class WorkerSessions implements ActiveMQServerPlugin {

    /** Form of the only filters that workers use, see {@link Queues#without}. */
    private static final Pattern FILTER = Pattern.compile(
        Queues.NEEDS + "[0-9a-f]{64} IS NULL( AND " + Queues.NEEDS + "[0-9a-f]{64} IS NULL)*+");
    private static final int LONGEST_FILTER = 1 << 16;
    /** Sessions of a connection: one for each game at a time, one that speaks, one that listens, and room. */
    private static final int MOST_SESSIONS = WorkerWord.MOST_SLOTS + 8;
    private static final String TYPE = Message.HDR_ROUTING_TYPE.toString();

    private final long quota;
    private final Map<String, State> workers = new ConcurrentHashMap<>();

    /** A worker's connection. Guarded by itself. */
    private static final class State {
        private String process = "";
        private RemotingConnection connection;
        private final Set<String> replaced = new TreeSet<>();
        private int sessions;
        private final AtomicLong waiting = new AtomicLong();
    }

    /** @param quota bytes of a worker's reports that may wait, those of open transactions included */
    WorkerSessions(long quota) {
        this.quota = quota;
    }

    private static boolean isLeague(RemotingConnection connection) {
        return connection == null || connection.getTransportConnection() instanceof InVMConnection;
    }

    private State state(String worker) {
        return workers.computeIfAbsent(worker, name -> new State());
    }

    @Override
    public void beforeCreateSession(String name, String worker, int largest, RemotingConnection connection,
                                    boolean commitSends, boolean commitAcks, boolean before, boolean xa, String address,
                                    SessionCallback callback, boolean create, OperationContext context,
                                    Map<SimpleString, RoutingType> prefixes) throws ActiveMQException {
        if (isLeague(connection)) {
            return;
        }
        if (String.valueOf(connection.getClientID()).startsWith(BrokerSecurity.REFUSED)) {
            throw rejected(connection.getClientID().substring(BrokerSecurity.REFUSED.length()));
        }
        State state = state(worker);
        RemotingConnection old;
        synchronized (state) {
            if (state.connection == connection) {
                if (++state.sessions > MOST_SESSIONS) {
                    throw rejected("found more than " + MOST_SESSIONS + " sessions, expected one for each game");
                }
                return;
            }
            String process = connection.getClientID();
            if (state.connection != null && state.replaced.contains(process)) {
                throw rejected("another worker plays with this token, expected one at a time");
            }
            if (!process.equals(state.process)) {
                state.replaced.add(state.process);
                state.replaced.remove(process);
            }
            old = state.connection;
            state.process = process;
            state.connection = connection;
            state.sessions = 1;
        }
        if (old != null) {
            old.fail(new ActiveMQException("a newer session of this token has taken over"));
        }
    }

    private static ActiveMQException rejected(String why) {
        return new ActiveMQException(why, ActiveMQExceptionType.SESSION_CREATION_REJECTED);
    }

    @Override
    public void afterCreateSession(ServerSession session) {
        if (session.getRemotingConnection().getTransportConnection() instanceof NettyServerConnection connection) {
            FrameGuard.loggedIn(connection.getNettyChannel());
        }
    }

    @Override
    public void afterCloseSession(ServerSession session, boolean failed) {
        State state = workers.get(session.getUsername());
        if (state != null) {
            synchronized (state) {
                state.sessions -= state.connection == session.getRemotingConnection() ? 1 : 0;
            }
        }
    }

    @Override
    public void afterDestroyConnection(RemotingConnection connection) {
        for (State state : workers.values()) {
            synchronized (state) {
                if (state.connection == connection) {
                    state.connection = null;
                    state.waiting.set(0);              // open transactions are rolled back with it
                }
            }
        }
    }

    @Override
    public void beforeCreateConsumer(long id, QueueBinding queue, SimpleString filter, boolean browse, boolean large)
            throws ActiveMQException {
        if (filter != null && !(filter.length() <= LONGEST_FILTER && FILTER.matcher(filter).matches())) {
            throw rejected("found a filter of " + filter.length() + " characters, expected one of bundles");
        }
    }

    @Override
    public void beforeSend(ServerSession session, Transaction transaction, Message message, boolean direct,
                           boolean create) throws ActiveMQException {
        if (isLeague(session.getRemotingConnection())) {
            return;
        }
        int size = message.getEncodeSize();
        boolean plain = !message.isLargeMessage() && !message.isDurable() && message.getExpiration() == 0
            && message.toCore().getType() == Message.DEFAULT_TYPE
            && message.getPropertyNames().stream().allMatch(name -> TYPE.equals(name.toString()))
            && size <= WireMessage.LONGEST + (1 << 16);
        if (!plain || state(session.getUsername()).waiting.addAndGet(size) > quota) {
            session.getRemotingConnection().fail(new ActiveMQException(plain ? "too much waits of this worker"
                : "found a message that no worker sends"));
            throw rejected("found a message that no worker sends, or too many of them");
        }
    }

    /** The league has read a report of so many bytes. */
    void read(String worker, int size) {
        State state = workers.get(worker);
        if (state != null) {
            state.waiting.updateAndGet(waiting -> Math.max(0, waiting - size));
        }
    }
}
