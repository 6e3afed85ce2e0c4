package steward.cli.tournament;

import java.io.IOException;
import java.net.Inet4Address;
import java.net.InetAddress;
import java.net.NetworkInterface;
import java.net.SocketException;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.function.Function;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import steward.cli.options.WatchOptions;
import steward.cli.streams.Streams;
import steward.files.Resources;
import steward.json.JsonObject;
import steward.league.StoredGame;
import steward.live.StatusServer;
import steward.replay.ReplayException;
import steward.replay.page.PageTemplate;
import steward.replay.page.ReplayPage;
import steward.report.Fields;
import steward.text.TextFormat;

/**
 * Page for a projector while a tournament is played. It shows the growing table and, at a speed that one can watch, one
 * game after the other, the newest with a kept replay. It shows nobody's stderr. When the tournament is over, it shows
 * the last table and begins no further game.
 */
final class ProjectorWall implements AutoCloseable {

    private static final String FOLDER = "/steward/tournament/";
    private static final Pattern REPLAY = Pattern.compile("replay/([0-9]{1,9})");
    private static final long PERIOD_NANOS = TimeUnit.SECONDS.toNanos(1);
    /** How long slow viewers are served after the end, in milliseconds. */
    private static final long DELIVERY_MS = 3000;

    private final StatusServer server;
    /** Games of this call with replays; the pages count them from 1. */
    private final List<StoredGame> kept = new ArrayList<>();
    private PlayedGames played;
    private Path replays;
    private Function<PlayedGames, Scores> table;
    private String says = "Programs are compiled and checked.";
    private boolean over;
    private long shown = System.nanoTime() - PERIOD_NANOS;

    private ProjectorWall(WatchOptions options) throws IOException {
        server = StatusServer.start(options.host(), options.port(), options.viewers(), page(), this::page);
    }

    /** Begins, and says where it is. */
    static ProjectorWall start(WatchOptions options, Streams streams) {
        try {
            ProjectorWall wall = new ProjectorWall(options);
            streams.err().println("Watch the tournament at " + wall.server.address());
            if (!wall.server.isLoopback()) {
                wall.phones(options.host()).forEach(each -> streams.err().println("  on phones: " + each));
                streams.warn("whoever reaches this machine can watch the tournament");
            }
            wall.show();
            return wall;
        } catch (IOException problem) {
            throw options.cannotListen(problem);
        }
    }

    /** The addresses by which other devices of a local network reach this one. */
    private List<URI> phones(String host) throws IOException {
        int port = server.address().getPort();
        if (!InetAddress.getByName(host).isAnyLocalAddress()) {
            return List.of(server.address());
        }
        try {
            return Collections.list(NetworkInterface.getNetworkInterfaces()).stream()
                .flatMap(NetworkInterface::inetAddresses)
                .filter(address -> address instanceof Inet4Address && !address.isLoopbackAddress())
                .map(address -> URI.create("http://" + address.getHostAddress() + ":" + port + "/")).toList();
        } catch (SocketException unknown) {
            return List.of();
        }
    }

    private static byte[] page() {
        String script = Resources.text(FOLDER + "wall.js");
        String style = Resources.text(FOLDER + "wall.css");
        ReplayPage.Shell shell = ReplayPage.shell();
        String data = PageTemplate.inScript(Fields.of("before", shell.before(), "after", shell.after()));
        return ("<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta "
            + "http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src "
            + PageTemplate.hash(script) + " " + shell.scriptHash() + "; style-src " + PageTemplate.hash(style) + " "
            + shell.styleHash() + "; img-src data:; connect-src 'self'; base-uri 'none'; form-action 'none'\">"
            + "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"><link rel=\"icon\" "
            + "href=\"data:,\"><style>" + style + "</style><title>Tournament</title></head><body><main>"
            + "<section aria-label=\"Table\"><h1>Tournament</h1><p id=\"says\" role=\"status\"></p><table><thead>"
            + "<tr><th>#<th>Program<th>Points<th>Games<th>Won<th>Drawn<th>Lost</tr></thead><tbody id=\"rows\">"
            + "</tbody></table><p class=\"key\">F: full screen</p></section>"
            + "<section aria-label=\"Game\"><h2 id=\"title\"></h2>"
            + "<iframe id=\"game\" title=\"The game that is shown\" tabindex=\"-1\"></iframe></section></main>"
            + "<script type=\"application/json\" id=\"data\">" + data + "</script><script>" + script
            + "</script></body></html>\n").getBytes(StandardCharsets.UTF_8);
    }

    /** A replay without anybody's stderr, and its details, as they stand in a page: a line each. */
    private byte[] page(String path) {
        Matcher number = REPLAY.matcher(path);
        StoredGame game = null;
        Path folder;
        synchronized (this) {
            if (number.matches()) {
                int place = Integer.parseInt(number.group(1)) - 1;
                game = place >= 0 && place < kept.size() ? kept.get(place) : null;
            }
            folder = replays;
        }
        try {
            if (game == null) {
                return null;
            }
            ReplayPage.Embedded found = ReplayPage.embedded(folder.resolve(game.replay()), null, seat -> false);
            return (found.replay() + "\n" + found.details()).getBytes(StandardCharsets.US_ASCII);
        } catch (IOException | ReplayException gone) {
            return null;
        }
    }

    /** Shows a line above the table. */
    synchronized void say(String line) {
        says = line;
        show();
    }

    /**
     * Follows games from now on.
     *
     * @param before those that are played already
     * @param scores the table of games
     */
    synchronized void follow(PlayedGames before, Path folder, Function<PlayedGames, Scores> scores) {
        played = before;
        replays = folder;
        table = scores;
        show();
    }

    /** A game is over. */
    synchronized void add(StoredGame game) {
        played = played.with(game);
        if (game.replay() != null) {
            kept.add(game);
        }
        if (System.nanoTime() - shown >= PERIOD_NANOS) {
            show();
        }
    }

    /** The tournament is over. */
    synchronized void end(PlayedGames all) {
        played = all;
        over = true;
        says = "The tournament is over.";
        show();
    }

    private void show() {
        shown = System.nanoTime();
        Scores scores = table == null ? null : table.apply(played);
        server.show(JsonObject.text(Fields.of("says", TextFormat.plain(says), "over", over, "game", kept.size(),
            "title", kept.isEmpty() ? "" : kept.get(kept.size() - 1).seats().stream()
                .map(seat -> played.names().get(seat.version())).collect(Collectors.joining(" against ")),
            "rows", scores == null ? List.of() : Fields.each(scores.rows(), row -> Fields.of("place", row.place(),
                "name", row.name(), "points", row.points(), "games", row.games(), "won", row.wins(),
                "drawn", row.draws(), "lost", row.losses())))::write));
    }

    @Override
    public void close() {
        server.end();
        try {
            server.awaitDelivery(DELIVERY_MS);
        } catch (InterruptedException interrupted) {
            Thread.currentThread().interrupt();
        }
        server.close();
    }
}
