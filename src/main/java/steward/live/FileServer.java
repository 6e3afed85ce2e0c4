package steward.live;

import java.io.IOException;
import java.net.URI;
import java.util.function.Function;

/**
 * Serves a page and the files of a viewer that it shows in a sandboxed frame, to browsers on this machine. The frame
 * has no origin, so whatever asks may read the files; the page itself is read by nobody else. The files may reach this
 * server alone.
 */
public final class FileServer implements AutoCloseable {

    private static final int VIEWERS = 1;

    private final HttpService service;

    private FileServer(HttpService service) {
        this.service = service;
    }

    /**
     * Starts a server on any port that is free.
     *
     * @param page  at {@code /}
     * @param files by their path without its first slash; gives {@code null} where there is none
     * @throws IOException if no port is free
     */
    public static FileServer start(byte[] page, Function<String, byte[]> files) throws IOException {
        return new FileServer(HttpService.start(null, 0, new Files(page, files), new Viewers(VIEWERS),
            LiveServer.SILENT_NANOS));
    }

    private record Files(byte[] front, Function<String, byte[]> files) implements Site {

        @Override
        public Feed feed() {
            return new Feed() {
                @Override
                public Piece piece(long position) {
                    return END;
                }

                @Override
                public boolean isComplete() {
                    return true;
                }

                @Override
                public void onChange(Runnable listener) {
                    // Nothing ever changes.
                }
            };
        }

        @Override
        public byte[] page(String path) {
            return files.apply(path);
        }

        @Override
        public boolean isOpen() {
            return true;
        }
    }

    /** The address of the page. */
    public URI address() {
        return service.address();
    }

    /** Closes all connections. */
    @Override
    public void close() {
        service.close();
    }
}
