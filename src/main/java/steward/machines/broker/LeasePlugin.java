package steward.machines.broker;

import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import org.apache.activemq.artemis.api.core.ActiveMQException;
import org.apache.activemq.artemis.core.server.ActiveMQServer;
import org.apache.activemq.artemis.core.server.MessageReference;
import org.apache.activemq.artemis.core.server.ServerConsumer;
import org.apache.activemq.artemis.core.server.ServerSession;
import org.apache.activemq.artemis.core.server.plugin.ActiveMQServerPlugin;

/** Notes which worker each job was handed to last. */
final class LeasePlugin implements ActiveMQServerPlugin {

    private final Map<String, String> leases = new ConcurrentHashMap<>();
    private final Map<String, Long> since = new ConcurrentHashMap<>();
    private volatile ActiveMQServer server;

    @Override
    public void registered(ActiveMQServer registered) {
        server = registered;
    }

    @Override
    public void beforeDeliver(ServerConsumer consumer, MessageReference reference) throws ActiveMQException {
        String job = reference.getMessage().getStringProperty(Queues.JOB);
        if (job != null) {
            ServerSession session = server.getSessionByID(consumer.getSessionID());
            if (session != null) {
                leases.put(job, session.getUsername());
                since.put(job, System.nanoTime());
            }
        }
    }

    /** Returns who has a job, or {@code null}. */
    String holder(String job) {
        return leases.get(job);
    }

    /** Since when, as {@link System#nanoTime}. */
    Long since(String job) {
        return since.get(job);
    }

    /** The job is over, or taken away. */
    void forget(String job) {
        leases.remove(job);
        since.remove(job);
    }
}
