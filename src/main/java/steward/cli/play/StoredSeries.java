package steward.cli.play;

import java.nio.ByteBuffer;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.IntStream;
import steward.bot.command.BotCommand;
import steward.bot.isolation.ChosenLocale;
import steward.cli.shared.Games;
import steward.cli.streams.Streams;
import steward.contest.Attempts;
import steward.contest.Contest;
import steward.contest.PairedPlay;
import steward.contest.ProgramWatch;
import steward.contest.Series;
import steward.files.InputException;
import steward.league.BotIdentity;
import steward.league.ChosenSeeds;
import steward.league.GameName;
import steward.league.LeagueBot;
import steward.league.LeagueFolder;
import steward.league.LeagueReader;
import steward.league.LeagueSettings;
import steward.league.Season;
import steward.league.StoredGame;
import steward.league.StoredGame.StoredSeat;
import steward.league.store.GameQueries;
import steward.league.store.GameStore;
import steward.league.store.GameStore.Version;
import steward.league.store.SeasonOpening;
import steward.match.MatchResult;
import steward.match.OwnLimits;
import steward.text.TextFormat;

/**
 * Games between the bots of a contest, stored in a league ({@code --into}) when each is over, and found again there.
 */
public final class StoredSeries implements AutoCloseable {

    private final GameStore store;
    private final Season season;
    private final int number;
    private final GameQueries games;
    private final Contest contest;
    private final String machine;
    private final Map<Integer, Version> versions = new HashMap<>();
    private boolean random;
    private ChosenSeeds chosen;

    private StoredSeries(GameStore store, Season season, int number, Contest contest, String machine) {
        this.store = store;
        this.season = season;
        this.contest = contest;
        this.machine = machine;
        this.number = number;
        games = new GameQueries(store, number, season);
    }

    /** Play of games that are stored. */
    public interface Play {

        /** Plays until it is over, or {@code watch} has found another program; returns the exit status. */
        int play(StoredSeries store, ProgramWatch watch) throws InterruptedException;
    }

    /** A watch over the programs of a contest that says what is waited for. */
    public static ProgramWatch watch(Contest contest, Streams streams) {
        return ProgramWatch.of(contest, what -> streams.err().println("steward: " + TextFormat.plain(what)));
    }

    /**
     * Plays in a league. When a program becomes another one, a new version begins, and the play anew.
     *
     * @param path of the league
     * @see #open
     */
    public static int play(Path path, Contest contest, double factor, List<String> environment, Streams streams,
                           Play play) throws InterruptedException {
        for (;;) {
            ProgramWatch watch = watch(contest, streams);
            int status;
            try (StoredSeries stored = open(path, contest, factor, environment, streams)) {
                status = play.play(stored, watch);
            }
            if (watch.changed() == null) {
                return status;
            }
            streams.err().println("steward: it begins anew, with a new version");
        }
    }

    /**
     * Opens the league.
     *
     * @param factor      of the time limits
     * @param environment the variables that bots are passed by name
     * @param streams     for a warning if others could read the folder
     * @throws InputException if its games are of another scene, limits or rules
     */
    public static StoredSeries open(Path path, Contest contest, double factor, List<String> environment,
        Streams streams) {
        LeagueFolder folder = LeagueFolder.openToWrite(path, streams::warn);
        LeagueSettings settings = folder.read();
        LeagueSettings played = settings.with(settings.gauntlet(), factor, settings.keep())
            .holding(contest.staging().isolation().get().hold());
        Season season = Season.of(contest.setup(), new LeagueSettings(played.scene(), played.seed(),
            played.seedFile(), played.gauntlet(), played.adaptive(), played.lag(), factor, contest.time().basis(),
            played.hiccups(), played.sandbox(), played.keep(), played.keepOf(), played.bots()));
        Season own = Season.of(Games.open(folder.scene(settings.scene())), settings);
        if (!own.key().equals(season.key())) {
            throw new InputException("--into: found a league of other games, expected one of the same scene and "
                + "limits: "
                + own.difference(season));
        }
        GameStore store = GameStore.write(folder);
        try {
            int number = SeasonOpening.open(folder, store, season, false);
            StoredSeries stored = new StoredSeries(store, season, number, contest, "match, "
                + System.getProperty("os.name") + " " + System.getProperty("os.arch") + ", Java "
                + System.getProperty("java.version") + ", sandbox "
                + contest.sandbox());
            Map<String, String> passed = new TreeMap<>();
            environment.forEach(name -> passed.put(name, String.valueOf(ChosenLocale.variable(name))));
            stored.find(settings, new BotIdentity(passed));
            stored.chosen = ChosenSeeds.of(folder, settings).by(contest.entrants());
            return stored;
        } catch (InputException problem) {
            store.close();
            throw problem;
        }
    }

    /** Returns the store of games between some of these bots, which is closed with this one. */
    public StoredSeries between(Contest some) {
        StoredSeries other = new StoredSeries(store, season, number, some, machine);
        for (int k = 0; k < some.entrants().size(); k++) {
            other.versions.put(k, versions.get(contest.entrants().indexOf(some.entrants().get(k))));
        }
        other.random = random;
        other.chosen = chosen;
        return other;
    }

    private void find(LeagueSettings settings, BotIdentity identity) {
        for (int k = 0; k < contest.entrants().size(); k++) {
            Contest.Entrant entrant = contest.entrants().get(k);
            String command = BotCommand.parse(entrant.bot()).name() == null ? entrant.bot()
                : entrant.bot().substring(entrant.bot().indexOf('=') + 1);
            random |= settings.bot(entrant.name()).filter(LeagueBot::random).isPresent();
            List<String> files = settings.bot(entrant.name()).filter(bot -> bot.command().equals(command))
                .map(LeagueBot::files).orElse(null);
            String name = LeagueReader.NAME.matcher(entrant.name()).matches() ? entrant.name() : "bot-" + (k + 1);
            LeagueBot bot = new LeagueBot(name, command, files, false, false)
                .in(none -> entrant.program().folder().toString()).within(entrant.limits());
            String hash = identity.of(bot);
            versions.put(k, store.version(hash).orElseGet(() -> store.add(name, command,
                OwnLimits.writtenOrNull(bot.limits()), false, hash, System.currentTimeMillis())));
        }
    }

    /** Stores a game, and what it replaces if it was played again. */
    public void add(Series.Played game) {
        List<Series.Played> attempts = new ArrayList<>();
        for (Series.Played each = game; each != null; each = each.starved()) {
            attempts.add(0, each);
        }
        List<StoredGame> stored = new ArrayList<>();
        for (Series.Played each : attempts) {
            stored.add(stored(each, stored.size() + 1, each == game));
        }
        store.add(number, stored);
    }

    private StoredGame stored(Series.Played game, int attempt, boolean last) {
        MatchResult result = game.result();
        List<StoredSeat> seats = new ArrayList<>();
        String[] identities = new String[season.players()];
        for (int player = 0; player < identities.length; player++) {
            Version version = versions.get(game.entrantOf(contest, player));
            identities[player] = version.identity();
            seats.add(StoredSeat.of(version.id(), result, player, game.facts().values(player)));
        }
        return new StoredGame(0, GameName.of(season, game.seed(), Arrays.asList(identities), attempt), -1, game.seed(),
            attempt, last && result != null, result == null ? 0 : result.turns(), result == null
                ? String.valueOf(game.failure()) : null, System.currentTimeMillis(), machine, null,
            game.facts().transcript(), seats);
    }

    /** The game as it is stored; {@code null} if it is not there. */
    public PairedPlay.Outcome outcome(long seed, int rotation) {
        List<String> identities = IntStream.range(0, season.players())
            .mapToObj(player -> versions.get(contest.entrantOf(player, rotation)).identity()).toList();
        for (int attempt = 1; attempt <= Attempts.MOST; attempt++) {
            StoredGame found = games.game(GameName.of(season, seed, identities, attempt));
            if (found != null && found.counts()) {
                return outcome(found);
            }
        }
        return null;
    }

    private PairedPlay.Outcome outcome(StoredGame game) {
        double[] values = game.seats().stream().mapToDouble(seat -> !contest.isAlone() ? -seat.rank()
            : season.lowerScoreIsBetter() ? -seat.score() : seat.score()).toArray();
        return new PairedPlay.Outcome(game.allFailed() ? null : values, game.allFailed(), game.transcript(),
            game.failed());
    }

    /** Seeds of games between these bots that are stored, ascending; not all of them have all games. */
    public SortedSet<Long> seeds() {
        SortedSet<Long> seeds = new TreeSet<>();
        List<Integer> group = versions.values().stream().map(Version::id).sorted().toList();
        games.gamesOf(versions.get(0).id(), game -> {
            if (contest.isAlone() || Arrays.stream(game.lineup()).sorted().boxed().toList().equals(group)) {
                seeds.add(game.seed());
            }
        });
        return seeds;
    }

    /** Returns the lists of seeds that games of these bots chose and that were played in the league. */
    public ChosenSeeds chosen() {
        return chosen;
    }

    /** A seed that belongs to these bots: the same in every call. */
    public long ownSeed() {
        List<String> identities = IntStream.range(0, versions.size()).mapToObj(k -> versions.get(k).identity())
            .toList();
        return ByteBuffer.wrap(GameName.of(season, 0, identities, 0)).getLong() >>> 2;
    }

    /** True if a bot is marked as one that draws by lot: equal games of its are independent draws. */
    public boolean isRandom() {
        return random || versions.values().stream().anyMatch(Version::random);
    }

    /** Refuses bots of which the first two have the same program. */
    public void refuseTwins() {
        if (versions.get(0).id() == versions.get(1).id()) {
            throw new InputException("found the same program twice, as '" + contest.entrants().get(0).name()
                + "' and as '" + contest.entrants().get(1).name()
                + "', expected bots that differ in command, environment or files");
        }
    }

    @Override
    public void close() {
        store.close();
    }
}
