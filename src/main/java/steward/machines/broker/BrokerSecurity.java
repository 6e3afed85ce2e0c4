package steward.machines.broker;

import java.util.Set;
import javax.security.auth.Subject;
import org.apache.activemq.artemis.core.remoting.impl.invm.InVMConnection;
import org.apache.activemq.artemis.core.security.CheckType;
import org.apache.activemq.artemis.core.security.Role;
import org.apache.activemq.artemis.spi.core.protocol.RemotingConnection;
import org.apache.activemq.artemis.spi.core.security.ActiveMQSecurityManager5;
import org.apache.activemq.artemis.spi.core.security.jaas.NoCacheLoginException;
import org.apache.activemq.artemis.spi.core.security.jaas.UserPrincipal;

/**
 * Permissions at the broker. The league itself, in the same process, may do everything. A worker may take jobs, send
 * reports and read messages to it, and nothing else.
 */
final class BrokerSecurity implements ActiveMQSecurityManager5 {

    /**
     * Mark in a password between its three parts: a worker's secret; the secret of an invitation, which may be empty;
     * and the name of the worker's process, so that it is known when the first session is made. Artemis has a client's
     * id for that, but sends it only once it knows the broker's version.
     */
    static final String MARK = " ";
    /** Beginning of a client's id, before the reason, for {@link WorkerSessions} to refuse it with. */
    static final String REFUSED = "refused: ";
    private static final int PARTS = 3;

    private final String league;
    private final String secret;
    private final Admission admission;

    /**
     * @param league    the name of the league itself, which no worker can have
     * @param admission of workers
     */
    BrokerSecurity(String league, String secret, Admission admission) {
        this.league = league;
        this.secret = secret;
        this.admission = admission;
    }

    @Override
    public Subject authenticate(String user, String password, RemotingConnection connection, String domain)
            throws NoCacheLoginException {
        boolean inside = connection != null && connection.getTransportConnection() instanceof InVMConnection;
        String[] parts = password == null ? new String[] {null} : password.split(MARK, PARTS);
        boolean known = inside ? league.equals(user) && secret.equals(password)
            : !league.equals(user) && admission.admits(user, parts[0]);
        boolean invited = !inside && !known && connection != null && parts.length == PARTS && user != null
            && !parts[1].isEmpty() && !league.equals(user);
        if (!known && !invited) {
            throw new NoCacheLoginException("unknown, or revoked");
        }
        // An exception here would not tell why: the reason goes to the session that is about to be made.
        String refusal = invited ? admission.enrol(user, parts[0], parts[1]) : null;
        if (!inside && connection != null) {
            connection.setClientID(refusal != null ? REFUSED + refusal : parts.length == PARTS ? parts[2] : "");
        }
        Subject subject = new Subject();
        subject.getPrincipals().add(new UserPrincipal(refusal == null ? user : REFUSED));
        return subject;
    }

    @Override
    public boolean authorize(Subject subject, Set<Role> roles, CheckType type, String address) {
        String user = subject == null ? null : getUserFromSubject(subject);
        if (user == null || address == null) {
            return false;
        }
        return user.equals(league) || isAllowed(user, type, address.split("::|\\.(?=jobs$)")[0]);
    }

    private static boolean isAllowed(String user, CheckType type, String address) {
        return switch (type) {
            case CONSUME -> address.equals(Queues.JOBS) || isOwn(user, address);
            case SEND -> address.equals(Queues.REPORTS);
            default -> false;
        };
    }

    /** A consumer is checked by its address and queue, which have the same name. */
    private static boolean isOwn(String user, String address) {
        String own = Queues.TO + user;
        return address.equals(own) || address.equals(own + "." + own);
    }

    @Override
    public String getUserFromSubject(Subject subject) {
        return subject.getPrincipals(UserPrincipal.class).stream().map(UserPrincipal::getName).findFirst()
            .orElse(null);
    }

    @Override
    public boolean validateUser(String user, String password) {
        return false;                                  // the methods above are asked instead
    }

    @Override
    public boolean validateUserAndRole(String user, String password, Set<Role> roles, CheckType type) {
        return false;
    }
}
