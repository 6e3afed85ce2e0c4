package steward.machines.broker;

import io.netty.buffer.ByteBuf;
import io.netty.channel.Channel;
import io.netty.channel.ChannelHandlerContext;
import io.netty.channel.ChannelInboundHandlerAdapter;
import io.netty.util.AttributeKey;
import java.nio.charset.StandardCharsets;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import org.apache.activemq.artemis.core.protocol.core.impl.PacketImpl;
import steward.machines.wire.WireMessage;

/**
 * Network filter between TLS and Artemis that closes harmful connections of workers. It closes a connection that begins
 * with another protocol (Artemis would collect an HTTP request of any length) or has not logged in within {@value
 * #LOGIN_SECONDS} seconds. It also refuses a frame that is longer than a worker's longest message, or of a type that a
 * worker does not need, such as a large message, which Artemis collects without a bound.
 *
 * <p>A frame of Artemis has four bytes with the length of the rest, a byte with its type, and its fields. The bytes
 * themselves are passed on unchanged.
 */
final class FrameGuard extends ChannelInboundHandlerAdapter {

    /** Time from the connection to the first session, in seconds. */
    static final int LOGIN_SECONDS = 5;
    /** Set on a connection when a session is made, which needs a token. */
    private static final AttributeKey<Boolean> LOGGED_IN = AttributeKey.valueOf("steward.loggedIn");
    private static final byte[] PREAMBLE = "ARTEMIS".getBytes(StandardCharsets.US_ASCII);
    private static final int HEADER = Integer.BYTES + 1;
    /** Longest frame before the login, in bytes: names, a token, and room. */
    private static final int LONGEST_LOGIN = 1 << 12;
    /** Longest frame after it, in bytes: a message with its properties. */
    private static final int LONGEST = WireMessage.LONGEST + (1 << 16);
    /** Frames up to this length take nothing of what all connections may collect together, in bytes. */
    private static final int SMALL = 1 << 18;
    private static final Set<Byte> LOGIN = Set.of(PacketImpl.PING, PacketImpl.DISCONNECT,
        PacketImpl.SUBSCRIBE_TOPOLOGY_V2, PacketImpl.CHECK_FOR_FAILOVER, PacketImpl.CREATESESSION,
        PacketImpl.CREATESESSION_V2);
    private static final Set<Byte> SESSION = Set.of(PacketImpl.SESS_CREATECONSUMER, PacketImpl.SESS_CONSUMER_CLOSE,
        PacketImpl.SESS_ACKNOWLEDGE, PacketImpl.SESS_COMMIT, PacketImpl.SESS_ROLLBACK, PacketImpl.SESS_BINDINGQUERY,
        PacketImpl.SESS_QUEUEQUERY, PacketImpl.SESS_START, PacketImpl.SESS_STOP, PacketImpl.SESS_CLOSE,
        PacketImpl.SESS_FLOWTOKEN, PacketImpl.SESS_SEND, PacketImpl.SESS_FORCE_CONSUMER_DELIVERY,
        PacketImpl.SESS_PRODUCER_REQUEST_CREDITS, PacketImpl.PACKETS_CONFIRMED, PacketImpl.CREATE_PRODUCER,
        PacketImpl.REMOVE_PRODUCER);

    /** Bytes that the incomplete long frames of all connections may still take. */
    private final AtomicLong room;
    private int preamble;
    private int headerBytes;
    private int length;
    /** Bytes of the frame that are still to come, behind its header. */
    private int rest;
    private long taken;
    private boolean closed;

    /** @param room shared by the connections of a broker */
    FrameGuard(AtomicLong room) {
        this.room = room;
    }

    /** Notes that a connection has shown a token. */
    static void loggedIn(Channel channel) {
        channel.attr(LOGGED_IN).set(true);
    }

    private static boolean isLoggedIn(ChannelHandlerContext context) {
        return context.channel().attr(LOGGED_IN).get() != null;
    }

    @Override
    public void handlerAdded(ChannelHandlerContext context) {
        context.executor().schedule(() -> {
            if (!isLoggedIn(context)) {
                context.close();
            }
        }, LOGIN_SECONDS, TimeUnit.SECONDS);
    }

    @Override
    public void handlerRemoved(ChannelHandlerContext context) {
        giveBack();
    }

    @Override
    public void channelRead(ChannelHandlerContext context, Object message) {
        ByteBuf bytes = (ByteBuf) message;
        if (closed || !mayPass(context, bytes)) {
            closed = true;
            bytes.release();
            context.close();
            return;
        }
        context.fireChannelRead(message);
    }

    private boolean mayPass(ChannelHandlerContext context, ByteBuf bytes) {
        int at = bytes.readerIndex();
        while (at < bytes.writerIndex()) {
            if (preamble < PREAMBLE.length) {
                if (bytes.getByte(at++) != PREAMBLE[preamble++]) {
                    return false;
                }
            } else if (rest > 0) {
                int read = Math.min(rest, bytes.writerIndex() - at);
                at += read;
                rest -= read;
            } else if (headerBytes < Integer.BYTES) {
                length = length << Byte.SIZE | bytes.getByte(at++) & 0xff;
                headerBytes++;
            } else if (!begins(isLoggedIn(context), bytes.getByte(at++))) {
                return false;
            }
        }
        return true;
    }

    /** Takes in the header of a frame. @return false if it is refused */
    private boolean begins(boolean loggedIn, byte type) {
        giveBack();
        if (length < 1 || length > (loggedIn ? LONGEST : LONGEST_LOGIN)
                || !LOGIN.contains(type) && !(loggedIn && SESSION.contains(type))) {
            return false;
        }
        if (length > SMALL) {
            taken = length;
            if (room.addAndGet(-taken) < 0) {
                return false;
            }
        }
        rest = length - (HEADER - Integer.BYTES);
        headerBytes = 0;
        length = 0;
        return true;
    }

    private void giveBack() {
        room.addAndGet(taken);
        taken = 0;
    }
}
