package steward.machines.broker;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import javax.net.ssl.SSLSocket;
import org.apache.activemq.artemis.api.core.TransportConfiguration;
import org.apache.activemq.artemis.api.core.client.ActiveMQClient;
import org.apache.activemq.artemis.api.core.client.ServerLocator;
import org.apache.activemq.artemis.core.remoting.impl.netty.NettyConnectorFactory;
import org.apache.activemq.artemis.core.remoting.impl.netty.TransportConstants;
import steward.cli.FreePort;
import steward.league.LeagueFolder;
import steward.machines.token.BrokerKey;
import steward.machines.token.SharedBrokerKey;
import steward.machines.token.WorkerList;
import steward.machines.token.WorkerToken;

/** A league's broker with some workers, and clients that are not ours. */
final class ServedBroker implements AutoCloseable {

    final LeagueBroker broker;
    private final Path folder;
    private final int port;

    ServedBroker(Path folder, String... workers) throws IOException {
        this(prepared(folder, workers), LeagueBroker.QUOTA, List.of(workers));
    }

    /** @param quota bytes of one worker's reports that may wait */
    ServedBroker(Path folder, long quota, String... workers) throws IOException {
        this(prepared(folder, workers), quota, List.of(workers));
    }

    /** A broker in a folder that is {@linkplain #prepared prepared}. */
    ServedBroker(Path folder, long quota, List<String> workers) throws IOException {
        this.folder = folder;
        LeagueFolder league = new LeagueFolder(folder.resolve("league"));
        port = FreePort.next();
        WorkerList list = WorkerList.read(league);
        broker = new LeagueBroker(new InetSocketAddress("127.0.0.1", port), new BrokerKey(league),
            workers, list::admits, quota);
    }

    /** Returns the folder, with a league in it and the tokens of its workers. */
    static Path prepared(Path folder, String... workers) throws IOException {
        LeagueFolder league = new LeagueFolder(Files.createDirectory(folder.resolve("league")));
        SharedBrokerKey.put(league);
        for (String worker : workers) {
            WorkerList.add(league, worker, folder.resolve(worker + ".token"));
        }
        return folder;
    }

    /** Clients of a broker of another process. */
    ServedBroker(Path folder, int port) {
        this.folder = folder;
        this.port = port;
        broker = null;
    }

    int port() {
        return port;
    }

    WorkerToken token(String worker) {
        return WorkerToken.read(folder.resolve(worker + ".token"));
    }

    /** A locator of Artemis, which may be set to anything. */
    ServerLocator locator(String worker) throws Exception {
        Map<String, Object> options = new HashMap<>();
        options.put(TransportConstants.HOST_PROP_NAME, "127.0.0.1");
        options.put(TransportConstants.PORT_PROP_NAME, Integer.toString(port));
        options.put(TransportConstants.SSL_ENABLED_PROP_NAME, "true");
        options.put(TransportConstants.SSL_CONTEXT_PROP_NAME, PinnedContextFactory.PIN + token(worker).broker());
        options.put(TransportConstants.VERIFY_HOST_PROP_NAME, "false");
        return ActiveMQClient.createServerLocatorWithoutHA(new TransportConfiguration(
            NettyConnectorFactory.class.getName(), options)).setReconnectAttempts(0).setBlockOnNonDurableSend(true);
    }

    /** Our own client. */
    BrokerClient client(String worker, String process) throws BrokerClient.BrokenException {
        return new BrokerClient("127.0.0.1", port, token(worker), process);
    }

    /** A connection of TLS of somebody without a token. */
    SSLSocket stranger() throws Exception {
        SSLSocket socket = (SSLSocket) PinnedContextFactory.context(token("one").broker()).getSocketFactory()
            .createSocket("127.0.0.1", port);
        socket.setSoTimeout(60_000);
        return socket;
    }

    /** Next message of a worker, as text. */
    List<String> report() throws InterruptedException {
        LeagueBroker.Report report = null;
        while (report == null) {
            report = broker.next(500);
        }
        return List.of(report.worker(), new String(report.bytes(), java.nio.charset.StandardCharsets.UTF_8));
    }

    @Override
    public void close() {
        broker.close();
    }
}
