package steward.machines.broker;

import java.io.Closeable;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicInteger;

/** Stands between workers and a league on this machine, and can cut every connection in the middle of a message. */
public final class CutProxy implements Closeable {

    private static final int CHUNK = 4096;

    private final ServerSocket server;
    private final int target;
    private final Set<Socket> open = ConcurrentHashMap.newKeySet();
    private final AtomicInteger cut = new AtomicInteger();
    private final AtomicInteger heardOfWorkers = new AtomicInteger();
    private final AtomicInteger heardOfLeague = new AtomicInteger();
    private volatile boolean closed;
    private volatile boolean cutting;

    /** @param target the port of the league on this machine */
    public CutProxy(int target) throws IOException {
        this.target = target;
        server = new ServerSocket(0, 50, InetAddress.getLoopbackAddress());
        start(this::accept);
    }

    public int port() {
        return server.getLocalPort();
    }

    /** Returns the number of times that something has come of workers. */
    int heardOfWorkers() {
        return heardOfWorkers.get();
    }

    /** Returns the number of times that something has come of the league. */
    int heardOfLeague() {
        return heardOfLeague.get();
    }

    private static void start(Runnable work) {
        Thread thread = new Thread(work, "proxy");
        thread.setDaemon(true);
        thread.start();
    }

    private void accept() {
        while (!closed) {
            try {
                Socket near = server.accept();
                open.add(near);
                if (cutting) {
                    close(near);
                    continue;
                }
                Socket far = new Socket();
                open.add(far);
                start(() -> join(near, far));
            } catch (IOException end) {
                return;
            }
        }
    }

    private void join(Socket near, Socket far) {
        try {
            far.connect(new InetSocketAddress(InetAddress.getLoopbackAddress(), target));
        } catch (IOException nobody) {
            close(near);
            close(far);
            return;
        }
        start(() -> pump(near, far, heardOfWorkers));
        pump(far, near, heardOfLeague);
    }

    /** Copies until one side ends; of what comes while connections are cut only the half goes through. */
    private void pump(Socket from, Socket to, AtomicInteger heard) {
        try {
            InputStream in = from.getInputStream();
            OutputStream out = to.getOutputStream();
            byte[] bytes = new byte[CHUNK];
            for (int read = in.read(bytes); read >= 0; read = in.read(bytes)) {
                heard.incrementAndGet();
                out.write(bytes, 0, cutting ? read / 2 : read);
                if (cutting) {
                    cut.incrementAndGet();
                    break;
                }
            }
        } catch (IOException end) {
            // the other side is closed below
        }
        close(from);
        close(to);
    }

    private void close(Socket socket) {
        open.remove(socket);
        try {
            socket.close();
        } catch (IOException gone) {
            return;
        }
    }

    /**
     * Cuts all connections within their next message, and takes no other for so long.
     *
     * @return how many were cut within a message
     */
    public int cut(long millis) throws InterruptedException {
        cut.set(0);
        cutting = true;
        Thread.sleep(millis);
        open.forEach(this::close);
        int found = cut.get();
        cutting = false;
        return found;
    }

    @Override
    public void close() throws IOException {
        closed = true;
        server.close();
        open.forEach(this::close);
    }
}
