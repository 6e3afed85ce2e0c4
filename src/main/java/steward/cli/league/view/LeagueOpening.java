package steward.cli.league.view;

import java.nio.file.Files;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import picocli.CommandLine;
import steward.bot.isolation.ChosenLocale;
import steward.bot.isolation.Isolation;
import steward.cli.options.SandboxOptions;
import steward.cli.options.SeedFileOption;
import steward.cli.shared.CallException;
import steward.cli.shared.Games;
import steward.cli.streams.Streams;
import steward.contest.Contest;
import steward.contest.seeds.SeedFile;
import steward.files.InputException;
import steward.game.GameSetup;
import steward.league.ChosenSeeds;
import steward.league.LeagueBot;
import steward.league.LeagueFolder;
import steward.league.LeagueSettings;
import steward.league.Season;
import steward.league.page.WorkerRow;
import steward.league.rating.LeagueTable;
import steward.league.store.GameQueries;
import steward.league.store.GameStore;
import steward.text.NearestName;

/** Opening of the scene, the season and the bots that a league's settings name. */
public final class LeagueOpening {

    private static final String TUNED = "tune.";

    private LeagueOpening() { }

    public static GameSetup setup(LeagueFolder folder, LeagueSettings settings) {
        return folder.named(() -> Games.open(folder.scene(settings.scene())));
    }

    /** Returns the match that is played, without bots. */
    public static Contest contest(LeagueFolder folder, LeagueSettings settings, Streams streams) {
        return Contest.withoutBots(Games.warn(setup(folder, settings), streams), settings.factor())
            .limitedBy(settings.basis()).isolatedBy(isolation(folder, settings, streams));
    }

    private static Supplier<Isolation> isolation(LeagueFolder folder, LeagueSettings settings, Streams streams) {
        try {
            Supplier<Isolation> named = CommandLine.populateCommand(new SandboxOptions(),
                settings.sandbox().toArray(new String[0])).isolation(streams);
            return () -> named.get().hiding(List.of(folder.path().toAbsolutePath().normalize()));
        } catch (CallException | InputException | CommandLine.ParameterException problem) {
            throw new InputException(folder.settings() + ": sandbox, as an option of 'steward match': "
                + problem.getMessage());
        }
    }

    /** The variables that bots are passed by name. */
    public static Map<String, String> environment(LeagueSettings settings) {
        Map<String, String> passed = new TreeMap<>();
        for (Iterator<String> word = settings.sandbox().iterator(); word.hasNext();) {
            if (word.next().equals("--env") && word.hasNext()) {
                String name = word.next();
                passed.put(name, String.valueOf(ChosenLocale.variable(name)));
            }
        }
        return passed;
    }

    /** Names of the bots that play by whose games the league's list of seeds was chosen. */
    public static List<String> choosers(LeagueFolder folder, LeagueSettings settings) {
        SeedFile list = folder.seeds(settings);
        return list == null ? List.of() : settings.active().stream().map(LeagueBot::entrant)
            .filter(entrant -> entrant.problem() == null)
            .filter(entrant -> !SeedFileOption.choosers(list.choosers(), List.of(entrant)).isEmpty())
            .map(Contest.Entrant::name).toList();
    }

    public static LeagueBot bot(LeagueSettings settings, String name) {
        List<String> names = settings.bots().stream().map(LeagueBot::name).toList();
        return settings.bot(name).orElseThrow(() -> new InputException("found no bot '" + name + "' in the league, "
            + "expected " + (names.isEmpty() ? "one that was added" : "one of " + String.join(", ", names)
                + NearestName.question(name, names, "'"))));
    }

    /** All versions that can have a row of the table. */
    public static List<LeagueTable.Entry> entries(LeagueSettings settings, List<GameStore.Version> versions) {
        List<LeagueTable.Entry> entries = new ArrayList<>();
        for (GameStore.Version version : versions) {
            boolean present = versions.stream().noneMatch(other -> other.bot().equals(version.bot())
                && (other.played() > version.played()
                    || other.played() == version.played() && other.number() > version.number()));
            if (version.bot().startsWith(TUNED) && settings.bot(version.bot()).isEmpty()) {
                continue;                              // one of the many that 'steward tune' has tried
            }
            boolean active = present && settings.bot(version.bot()).filter(bot -> !bot.retired()).isPresent();
            boolean random = version.random() || settings.bot(version.bot()).filter(LeagueBot::random).isPresent();
            entries.add(new LeagueTable.Entry(version.id(), version.display(), random, active,
                version.paused()));
        }
        return entries;
    }

    /**
     * The games of the last season, opened for reading.
     *
     * @param settings as the file says now
     * @param store    to be closed
     * @param season   what all its games have in common
     * @param games    what can be read of them
     * @param entries  the versions of bots
     */
    public record Opened(LeagueFolder folder, LeagueSettings settings, GameStore store, Season season,
                         GameQueries games, List<LeagueTable.Entry> entries) implements AutoCloseable {

        public List<WorkerRow> workers() {
            return WorkerBooks.rows(WorkerBooks.read(games, store));
        }

        /** Names of the bots that play by whose games a list was chosen, of now or before; none where one is gone. */
        public List<String> choosers() {
            try {
                return ChosenSeeds.of(folder, settings).choosers(settings.active().stream().map(LeagueBot::entrant)
                    .toList());
            } catch (InputException gone) {
                return List.of();
            }
        }

        /** The names of all versions. */
        public Map<Integer, String> names() {
            return entries.stream().collect(Collectors.toMap(LeagueTable.Entry::version, LeagueTable.Entry::name));
        }

        @Override
        public void close() {
            store.close();
        }
    }

    /** Opens a league that has been played, for reading. */
    public static Opened read(LeagueFolder folder) {
        return opened(folder, folder.read(), Files.exists(folder.database()) ? GameStore.read(folder) : null);
    }

    /** Opens a league for writing. */
    public static Opened write(LeagueFolder folder) {
        return opened(folder, folder.read(), Files.exists(folder.database()) ? GameStore.write(folder) : null);
    }

    private static Opened opened(LeagueFolder folder, LeagueSettings settings, GameStore store) {
        Optional<Season> season = store == null ? Optional.empty() : store.lastSeason();
        if (season.isEmpty()) {
            if (store != null) {
                store.close();
            }
            throw new InputException(folder.path() + ": found a league without games, expected one that has been "
                + "played; 'steward league run " + folder.path() + "' plays it");
        }
        int number = store.season(season.get()).orElseThrow();
        return new Opened(folder, settings, store, season.get(),
            new GameQueries(store, number, season.get()), entries(settings, store.versions()));
    }
}
