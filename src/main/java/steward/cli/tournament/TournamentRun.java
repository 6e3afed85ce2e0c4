package steward.cli.tournament;

import java.io.IOException;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.atomic.AtomicLong;
import java.util.stream.Collectors;
import steward.cli.league.run.LeagueRunCommand;
import steward.cli.league.run.NoServing;
import steward.cli.league.view.LeagueOpening;
import steward.cli.shared.ExitStatus;
import steward.cli.streams.Streams;
import steward.contest.Contest;
import steward.league.LeagueFolder;
import steward.league.LeagueSettings;
import steward.league.Season;
import steward.league.StoredGame;
import steward.league.play.LeagueRun;
import steward.league.play.Roster;
import steward.league.play.RosterReader;
import steward.league.store.GameStore;
import steward.league.store.SeasonOpening;
import steward.text.TextFormat;

/**
 * Run of a tournament between the versions of programs that were found at its start: the games left to play, and the
 * table.
 */
final class TournamentRun {

    static final String ROUNDS = "rounds.json";

    private static final double NANOS = 1e9;

    private final LeagueFolder league;
    private final Roster roster;
    private final int players;
    private final Streams streams;
    private final String threads;
    private final ProjectorWall wall;
    /** Swiss rounds, or {@code null}. */
    private Rounds rounds;
    /** Decisions of each group that meets. */
    private int decisions;
    /** Number of games of this call. */
    private final AtomicLong games = new AtomicLong();

    /**
     * @param decisions that each group has when it meets
     * @param wall      that follows, or {@code null}
     */
    TournamentRun(LeagueFolder league, Roster roster, int players, int decisions, Streams streams, int threads,
                  ProjectorWall wall) {
        this.league = league;
        this.roster = roster;
        this.players = Math.max(1, players);
        this.decisions = decisions;
        this.streams = streams;
        this.threads = Integer.toString(threads);
        this.wall = wall;
    }

    /** The programs as they are now, each with its version. */
    static Roster roster(LeagueFolder league, LeagueSettings settings, Contest contest, Streams streams) {
        LeagueFolder.refuseRemote(league.path());
        try (GameStore store = GameStore.write(league)) {
            SeasonOpening.open(league, store, Season.of(contest.setup(), settings), false);
            return league.named(() -> new RosterReader(store, contest, LeagueOpening.environment(settings), false,
                what -> streams.err().println("steward: " + TextFormat.plain(what)), System::currentTimeMillis)
                .read(settings));
        }
    }

    /** Everybody meets everybody. @return the exit status */
    int playAll() throws Exception {
        return play((found, decided) -> {
            int most = decided.entrySet().stream().filter(each -> found.versions().containsAll(each.getKey()))
                .mapToInt(Map.Entry::getValue).max().orElse(0);
            if (most > decisions) {
                decisions = most;
                streams.err().println("steward: everybody meets everybody in " + most * players + " games, as before: "
                    + "some have met so often");
            }
            return group -> decisions;
        });
    }

    /** Plays so many Swiss rounds, or as many as have been decided on. @return the exit status */
    int playRounds(int most, Path into) throws Exception {
        rounds = Rounds.read(into.resolve(ROUNDS), roster.members().stream()
            .map(member -> member.version().display()).toList(),
            what -> streams.err().println("steward: " + TextFormat.plain(what)));
        int status = ExitStatus.DONE;
        long began = System.nanoTime();
        for (int number = 1; status == ExitStatus.DONE && number <= Math.max(most, rounds.rounds().size()); number++) {
            if (number > rounds.rounds().size()) {
                rounds.decide(number == 1 ? roster.members().stream().map(member -> member.bot().name()).toList()
                    : scores(played()).rows().stream().map(Scores.Row::name).toList(), players);
            }
            String text = rounds.text(number, players);
            streams.err().println(TextFormat.plain(text));
            if (wall != null) {
                wall.say(text);
            }
            status = play((found, decided) -> group -> decisions * rounds.met().getOrDefault(names(group), 0));
        }
        streams.out().println(LeagueRunCommand.playedText(games.get(), games.get() * NANOS
            / Math.max(1, System.nanoTime() - began)));
        return status;
    }

    private Set<String> names(List<Integer> versions) {
        return roster.members().stream().filter(member -> versions.contains(member.version().id()))
            .map(member -> member.bot().name()).collect(Collectors.toSet());
    }

    private int play(LeagueRun.Planner plan) throws Exception {
        if (wall != null) {
            wall.follow(played(), league.replays(), this::scores);
        }
        return new LeagueRunCommand(new NoServing()).following(plan, rounds != null, game -> {
            games.incrementAndGet();
            if (wall != null) {
                wall.add(game);
            }
        }).run(streams, league.path().toString(), "--pause-after", "0", "--anyway", "--threads", threads);
    }

    /** The games that table and pages are made from: of Swiss rounds, those of who met in them. */
    PlayedGames played() throws IOException {
        try (LeagueOpening.Opened opened = LeagueOpening.read(league)) {
            PlayedGames all = PlayedGames.read(opened, roster);
            return rounds == null ? all : new PlayedGames(all.season(), all.entries(), all.games().stream()
                .filter(this::isOfRounds).toList());
        }
    }

    private boolean isOfRounds(StoredGame game) {
        Set<Integer> versions = new HashSet<>();
        game.seats().forEach(seat -> versions.add(seat.version()));
        return rounds.met().containsKey(names(List.copyOf(versions)));
    }

    Scores scores(PlayedGames played) {
        return rounds == null ? Scores.of(played) : Scores.of(played, rounds, decisions * players);
    }
}
