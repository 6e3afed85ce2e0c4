package steward.cli.league.run;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import steward.cli.league.view.PageCommand;
import steward.cli.options.WatchOptions;
import steward.cli.shared.Games;
import steward.cli.shared.Pages;
import steward.cli.streams.Streams;
import steward.contest.WorkerThreads;
import steward.files.InputException;
import steward.league.LeagueFolder;
import steward.league.LeagueSettings;
import steward.league.Season;
import steward.league.StoredGame;
import steward.league.page.ErrorLines;
import steward.league.page.LeaguePage;
import steward.league.page.LeagueView;
import steward.league.play.LeagueRun;
import steward.league.rating.LeagueTable;
import steward.league.rating.RatingPath;
import steward.league.store.GameQueries;
import steward.live.StatusServer;
import steward.replay.ReplayException;

/** Live page that follows a run: sends the newest state to every open browser, and serves the kept replays. */
final class LeagueWatch implements AutoCloseable {

    private static final long PERIOD_MS = 1000;
    /** How long slow viewers are served after the end, in milliseconds. */
    private static final long DELIVERY_MS = 3000;
    private static final int LISTED = 300;
    /** The ratings over games are computed anew after so many times what that takes. */
    private static final int REST = 20;
    private static final Pattern REPLAY = Pattern.compile("replay/([0-9]{1,18})");

    private final LeagueFolder folder;
    private final Season season;
    private final GameQueries games;
    private final LeagueProgress progress;
    private final StatusServer server;
    private final ErrorLines errors;
    private final ScheduledExecutorService clock = Executors.newSingleThreadScheduledExecutor(
        WorkerThreads.daemons("league page"));
    private RatingPath path;
    private long pathDue = System.nanoTime();
    private long shown = -1;
    private LeagueRun run;
    private Serving.Service machines;

    private LeagueWatch(LeagueFolder folder, Season season, GameQueries games, LeagueProgress progress,
                        WatchOptions options) throws IOException {
        this.folder = folder;
        this.season = season;
        this.games = games;
        this.progress = progress;
        errors = new ErrorLines(folder.replays(), Games.types(), null);
        server = StatusServer.start(options.host(), options.port(), options.viewers(),
            LeaguePage.live(PageCommand.title(folder.path()), StatusServer.FEED), this::page);
    }

    /** @throws InputException if the port is taken or the host unknown */
    static LeagueWatch start(LeagueFolder folder, Season season, GameQueries games, LeagueProgress progress,
                             WatchOptions options) {
        try {
            return new LeagueWatch(folder, season, games, progress, options);
        } catch (IOException problem) {
            throw options.cannotListen(problem);
        }
    }

    /** Says where it is, and follows the run from now on, and other machines unless they are {@code null}. */
    void follow(LeagueRun followed, Serving.Service others, Streams streams, boolean open) throws InterruptedException {
        run = followed;
        machines = others;
        streams.err().println("Watch the league at " + server.address());
        if (!server.isLoopback()) {
            streams.warn("whoever reaches this machine can watch the league");
        }
        clock.scheduleWithFixedDelay(this::show, 0, PERIOD_MS, TimeUnit.MILLISECONDS);
        if (open) {
            Pages.open(streams, server.address());
        }
    }

    private synchronized void show() {
        long played = run.stored();
        if (played == shown && machines == null) {
            return;
        }
        LeagueSettings settings = run.roster().settings();
        LeagueTable table = progress.table(settings);
        try {
            if (System.nanoTime() - pathDue >= 0) {
                long began = System.nanoTime();
                path = games.path(table.rows().stream().map(LeagueTable.Row::entry).toList(),
                    table.reference());
                pathDue = System.nanoTime() + REST * (System.nanoTime() - began);
            }
            server.show(LeaguePage.live(new LeagueView(season, table, path, games.last(LISTED), progress.rate(),
                machines == null ? List.of() : machines.workers()), errors));
            shown = played;
        } catch (InputException busy) {
            return;                                    // the next second shows it
        }
    }

    private byte[] page(String address) {
        if (address.equals("metrics")) {
            return LeagueMetrics.text(run, progress.rate(), machines).getBytes(StandardCharsets.UTF_8);
        }
        Matcher matcher = REPLAY.matcher(address);
        if (!matcher.matches()) {
            return null;
        }
        StoredGame game = games.game(Long.parseLong(matcher.group(1)));
        Path file = game == null || game.replay() == null ? null : folder.replays().resolve(game.replay());
        if (file == null || !Files.isRegularFile(file)) {
            return null;
        }
        Map<Integer, String> names = new HashMap<>();
        progress.table(run.roster().settings()).rows()
            .forEach(row -> names.put(row.entry().version(), row.entry().name()));
        List<String> players = game.seats().stream().map(seat -> names.getOrDefault(seat.version(), "?")).toList();
        try {
            return Pages.of(file, Pages.title(players));
        } catch (ReplayException damaged) {
            return null;
        }
    }

    /** Shows the end. */
    @Override
    public void close() {
        clock.shutdown();
        try {
            clock.awaitTermination(DELIVERY_MS, TimeUnit.MILLISECONDS);
            if (run != null) {
                pathDue = System.nanoTime();
                shown = -1;
                show();
            }
            server.end();
            server.awaitDelivery(DELIVERY_MS);
        } catch (InterruptedException interrupted) {
            Thread.currentThread().interrupt();
        }
        server.close();
    }
}
