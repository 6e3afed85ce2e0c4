package steward.machines.broker;

import io.netty.buffer.ByteBufAllocator;
import io.netty.channel.ChannelHandlerContext;
import io.netty.handler.ssl.SslHandler;
import io.netty.handler.timeout.ReadTimeoutHandler;
import java.util.Map;
import java.util.concurrent.Executor;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import org.apache.activemq.artemis.core.remoting.impl.netty.NettyAcceptor;
import org.apache.activemq.artemis.core.server.cluster.ClusterConnection;
import org.apache.activemq.artemis.core.server.metrics.MetricsManager;
import org.apache.activemq.artemis.spi.core.protocol.ProtocolManager;
import org.apache.activemq.artemis.spi.core.remoting.Acceptor;
import org.apache.activemq.artemis.spi.core.remoting.AcceptorFactory;
import org.apache.activemq.artemis.spi.core.remoting.BufferHandler;
import org.apache.activemq.artemis.spi.core.remoting.ServerConnectionLifeCycleListener;
import org.apache.activemq.artemis.utils.actors.OrderedExecutor;

/**
 * Factory of TLS acceptors whose connections have a {@link FrameGuard} and are closed if they are silent. Artemis
 * creates it by the name of this class.
 */
public final class GuardedAcceptorFactory implements AcceptorFactory {

    /** Share of the heap that incomplete long frames of all connections may take together: one of this many parts. */
    private static final int PARTS = 4;

    /** Called by Artemis. */
    public GuardedAcceptorFactory() {
        super();
    }

    @Override
    public Acceptor createAcceptor(String name, ClusterConnection cluster, Map<String, Object> configuration,
                                   BufferHandler handler, ServerConnectionLifeCycleListener listener,
                                   Executor threadPool, ScheduledExecutorService scheduled,
                                   @SuppressWarnings("rawtypes") Map<String, ProtocolManager> protocols,
                                   String threadGroup, MetricsManager metrics) {
        AtomicLong room = new AtomicLong(Runtime.getRuntime().maxMemory() / PARTS);
        return new NettyAcceptor(name, cluster, configuration, handler, listener, scheduled,
            new OrderedExecutor(threadPool), protocols, threadGroup, metrics) {
            @Override
            public SslHandler getSslHandler(ByteBufAllocator memory, String host, int port) throws Exception {
                return new SslHandler(super.getSslHandler(memory, host, port).engine()) {
                    @Override
                    public void handlerAdded(ChannelHandlerContext context) throws Exception {
                        super.handlerAdded(context);
                        context.pipeline().addAfter(context.name(), "guard", new FrameGuard(room));
                        context.pipeline().addAfter(context.name(), "silence",
                            new ReadTimeoutHandler(LeagueBroker.TTL_MS, TimeUnit.MILLISECONDS));
                    }
                };
            }
        };
    }
}
