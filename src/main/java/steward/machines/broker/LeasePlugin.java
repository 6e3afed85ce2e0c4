package steward.machines.broker;

import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import org.apache.activemq.artemis.api.core.ActiveMQException;
import org.apache.activemq.artemis.core.server.ActiveMQServer;
import org.apache.activemq.artemis.core.server.MessageReference;
import org.apache.activemq.artemis.core.server.ServerConsumer;
import org.apache.activemq.artemis.core.server.ServerSession;
import org.apache.activemq.artemis.core.server.impl.AckReason;
import org.apache.activemq.artemis.core.server.plugin.ActiveMQServerPlugin;

/** Plugin of Artemis that decides which workers may be handed jobs, and records which worker got each job last. */
final class LeasePlugin implements ActiveMQServerPlugin {

    private final Admission admission;

    private final Map<String, String> leases = new ConcurrentHashMap<>();
    private final Map<String, Long> since = new ConcurrentHashMap<>();
    /** Sessions that have jobs which are not finished, by job. */
    private final Map<String, String> sessions = new ConcurrentHashMap<>();
    private volatile ActiveMQServer server;

    /** @param admission says who may be handed jobs */
    LeasePlugin(Admission admission) {
        this.admission = admission;
    }

    @Override
    public boolean canAccept(ServerConsumer consumer, MessageReference reference) {
        if (reference.getMessage().getStringProperty(Queues.JOB) == null) {
            return true;
        }
        ServerSession session = server.getSessionByID(consumer.getSessionID());
        return session != null && admission.mayTake(session.getUsername(),
            (int) leases.values().stream().filter(session.getUsername()::equals).count());
    }

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
                sessions.put(job, consumer.getSessionID());
                since.put(job, System.nanoTime());
                admission.took(session.getUsername());
            }
        }
    }

    @Override
    public void messageAcknowledged(MessageReference reference, AckReason reason, ServerConsumer consumer) {
        String job = reference.getMessage().getStringProperty(Queues.JOB);
        if (job != null) {
            sessions.remove(job);                      // its report may still wait
        }
    }

    /** Jobs that a session has not finished are nobody's again. */
    @Override
    public void afterCloseSession(ServerSession session, boolean failed) {
        sessions.forEach((job, holder) -> {
            if (holder.equals(session.getName()) && sessions.remove(job, holder)) {
                leases.remove(job);
                since.remove(job);
            }
        });
    }

    /** Who has a job, or {@code null}. */
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
        sessions.remove(job);
    }
}
