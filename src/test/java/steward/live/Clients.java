package steward.live;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.net.Socket;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;

/** Clients of a live server: an ordinary one, and one that writes requests byte by byte. */
public final class Clients implements AutoCloseable {

    private static final int TIMEOUT_MS = 20_000;

    private final HttpClient http = HttpClient.newHttpClient();
    private final URI address;
    private final List<LiveFeed> feeds = new ArrayList<>();

    /** @param address of the page */
    public Clients(URI address) {
        this.address = address;
    }

    int port() {
        return address.getPort();
    }

    private <T> HttpResponse<T> get(String path, HttpResponse.BodyHandler<T> body, String... headers) {
        HttpRequest.Builder request = HttpRequest.newBuilder(address.resolve(path));
        try {
            return http.send((headers.length == 0 ? request : request.headers(headers)).build(), body);
        } catch (IOException problem) {
            throw new UncheckedIOException(problem);
        } catch (InterruptedException problem) {
            throw new IllegalStateException(problem);
        }
    }

    /** The status of an answer whose body is not read. */
    int status(String path) throws IOException {
        HttpResponse<InputStream> response = get(path, HttpResponse.BodyHandlers.ofInputStream());
        response.body().close();
        return response.statusCode();
    }

    /** A page. */
    public String body(String path) {
        HttpResponse<String> response = get(path, HttpResponse.BodyHandlers.ofString());
        if (response.statusCode() != 200) {
            throw new AssertionError(response.statusCode() + " " + response.body());
        }
        return response.body();
    }

    /** Begins to follow the match. */
    public LiveFeed feed() {
        return feed(get("feed", HttpResponse.BodyHandlers.ofInputStream()));
    }

    /** Begins again, as a browser does that was disconnected. */
    LiveFeed feed(String lastId) {
        return feed(get("feed", HttpResponse.BodyHandlers.ofInputStream(), "Last-Event-ID", lastId));
    }

    private LiveFeed feed(HttpResponse<InputStream> response) {
        LiveFeed feed = new LiveFeed(response);
        feeds.add(feed);
        return feed;
    }

    /** Everything that is answered to a request of these lines. */
    String raw(String... lines) throws IOException {
        try (Socket socket = new Socket(address.getHost(), address.getPort())) {
            socket.setSoTimeout(TIMEOUT_MS);
            String request = String.join("\r\n", lines) + "\r\nConnection: close\r\n\r\n";
            socket.getOutputStream().write(request.getBytes(StandardCharsets.US_ASCII));
            return new String(socket.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        }
    }

    int rawStatus(String... lines) throws IOException {
        return Integer.parseInt(raw(lines).split(" ", 3)[1]);
    }

    @Override
    public void close() {
        feeds.forEach(LiveFeed::close);
    }

    /** Follows a match as a browser would, but reads only when it is told to. */
    public static final class LiveFeed implements AutoCloseable {

        private static final String DATA = "data: ";
        private static final String EVENT = "event: ";
        private static final String ID = "id:";

        private final BufferedReader in;
        private final InputStream stream;
        private String ending;
        private String id;

        private LiveFeed(HttpResponse<InputStream> response) {
            if (response.statusCode() != 200) {
                throw new AssertionError(response.statusCode());
            }
            stream = response.body();
            in = new BufferedReader(new InputStreamReader(stream, StandardCharsets.UTF_8), 4096);
        }

        /** The next line of the match, or {@code null} after the last. */
        public String next() throws IOException {
            for (String line = in.readLine(); line != null; line = in.readLine()) {
                if (line.startsWith(EVENT)) {
                    ending = line.substring(EVENT.length());
                } else if (line.startsWith(ID)) {
                    id = line.substring(ID.length());
                } else if (line.startsWith(DATA)) {
                    return line.substring(DATA.length());
                }
            }
            return null;
        }

        /** All lines from here on. */
        public List<String> rest() throws IOException {
            List<String> lines = new ArrayList<>();
            for (String line = next(); line != null; line = next()) {
                lines.add(line);
            }
            return lines;
        }

        /** The viewer's number, which comes before the first line. */
        String id() throws IOException {
            if (id == null) {
                id = in.readLine().substring(ID.length());
            }
            return id;
        }

        /** The kind of the last event, after the last line. */
        String ending() {
            return ending;
        }

        @Override
        public void close() {
            try {
                stream.close();
            } catch (IOException problem) {
                throw new UncheckedIOException(problem);
            }
        }
    }
}
