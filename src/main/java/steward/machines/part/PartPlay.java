package steward.machines.part;

import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Consumer;
import steward.bot.command.Platform;
import steward.contest.Contest;
import steward.contest.ProgramWatch;
import steward.contest.WorkerThreads;
import steward.files.InputException;
import steward.league.EarlierGames;
import steward.league.LeagueFolder;
import steward.league.LeagueSettings;
import steward.league.Pairing;
import steward.league.Schedule;
import steward.league.Season;
import steward.league.StoredGame;
import steward.league.play.Elsewhere;
import steward.league.play.GamePlay;
import steward.league.play.Roster;
import steward.league.play.Roster.Member;
import steward.league.store.GameQueries;
import steward.league.store.GameStore;
import steward.league.store.PartStore;
import steward.machines.check.TranscriptWriter;
import steward.match.MatchListener;
import steward.match.MatchResult;
import steward.match.TeeListener;

/**
 * Plays one part of a league's schedule: every so-manieth decision, from the state of the league as it lies there. The
 * schedule is fixed, so that all parts together are the games that one machine would play. The league's folder is only
 * read. A part that was ended goes on where it was.
 */
public final class PartPlay {

    private final PartStore part;
    private final Roster roster;
    private final ProgramWatch watch;
    private final Map<Integer, Member> members;
    private final GamePlay play;
    private final Schedule schedule;
    private final long end;
    private final Consumer<StoredGame> listener;
    private final Map<String, byte[]> transcripts = new ConcurrentHashMap<>();

    private boolean brokenOff;
    private String stopped;
    private int underWay;

    /**
     * Refuses a schedule that cannot be played in parts, before anything is written.
     *
     * @throws InputException if it depends on results
     */
    public static void check(LeagueSettings settings, Season season) {
        if (settings.adaptive() && season.players() > 1) {
            throw new InputException("pairing: found 'adaptive', which decides by results, expected 'round-robin' or "
                + "'gauntlet NAME': parts are played apart");
        }
    }

    /**
     * A part that is to be played.
     *
     * @param part     with the versions of its bots, see {@link #prepare}
     * @param roster   the bots
     * @param watch    over their programs
     * @param machine  what is noted with each game
     * @param nanos    after which no game is begun; {@code Long.MAX_VALUE} for no end
     * @param listener is told of each attempt that is stored, by any thread
     */
    public PartPlay(LeagueFolder folder, PartStore part, Roster roster, ProgramWatch watch, Contest contest,
                    String machine, long nanos, Consumer<StoredGame> listener) {
        this.part = part;
        this.roster = roster;
        this.watch = watch;
        this.listener = listener;
        members = roster.byVersion();
        play = new GamePlay(part.season(), contest, new Transcripts(), machine, System::currentTimeMillis);
        LeagueSettings settings = roster.settings();
        int players = part.season().players();
        folder.named(() -> roster.checked(players));
        try (GameStore league = GameStore.unused(folder)) {
            Optional<Integer> season = league == null ? Optional.empty() : league.season(part.season());
            schedule = new Schedule(settings.seed(), players, settings.lag(), season.isEmpty() ? new EarlierGames()
                : new GameQueries(league, season.get(), part.season()).earlier());
        }
        roster.members().stream().filter(member -> !member.playsHere()).findFirst().ifPresent(member -> {
            throw new InputException("bot '" + member.bot().name() + "': found a bot for another platform than "
                + Platform.here() + ", expected none in a league that is played in parts; retire it");
        });
        schedule.play(roster.versions(), versions -> settings.gauntlet() == null
            ? Pairing.roundRobin(versions, players)
            : Pairing.gauntlet(versions, players, roster.versionOf(settings.gauntlet()).orElseThrow()));
        end = nanos == Long.MAX_VALUE ? Long.MAX_VALUE : System.nanoTime() + nanos;
    }

    /** Gives a new part the versions of the league's bots, with their numbers: all parts then decide alike. */
    public static void prepare(LeagueFolder folder, PartStore part) {
        if (part.games().versions().isEmpty()) {
            try (GameStore league = GameStore.unused(folder)) {
                if (league != null) {
                    part.games().copyVersions(league);
                }
            }
        }
    }

    /** All transcripts go into the part: whoever merges it plays them again. */
    private final class Transcripts implements GamePlay.Recordings {

        @Override
        public GamePlay.Recorder recorder(LeagueSettings settings) {
            return new TranscriptRecorder();
        }

        @Override
        public String take(byte[] game, byte[] transcript, boolean kept) {
            transcripts.put(HexFormat.of().formatHex(game), transcript);
            return null;
        }
    }

    /** Transcript of an attempt that has a result. */
    private static final class TranscriptRecorder implements GamePlay.Recorder {

        private byte[] transcript;

        @Override
        public MatchResult play(Contest match, long seed, MatchListener log) throws InterruptedException {
            TranscriptWriter writer = new TranscriptWriter(match.entrants().stream().map(Contest.Entrant::bot).toList(),
                match.sandbox());
            MatchResult result = match.play(seed, 0, null, new TeeListener(writer, log));
            transcript = writer.compressed();
            return result;
        }

        @Override
        public byte[] recording() {
            return transcript;
        }
    }

    /** Plays until the part or the time is over. Call once. */
    public void play(int threads) throws InterruptedException {
        WorkerThreads.run("part", threads, thread -> () -> {
            while (watch.await(this::isOver)) {
                String mark = watch.mark();
                Schedule.Task task = next();
                if (task == null) {
                    return null;
                }
                play(task, mark);
            }
            stop(watch.changed() == null ? null : watch.changed() + " has changed while the part was played; a part "
                + "has one program for each bot");
            return null;
        });
    }

    private synchronized boolean isOver() {
        return brokenOff || stopped != null;
    }

    private synchronized void stop(String why) {
        stopped = stopped == null ? why : stopped;
        notifyAll();
    }

    private synchronized Schedule.Task next() throws InterruptedException {
        while (!brokenOff && stopped == null && (end == Long.MAX_VALUE || System.nanoTime() - end < 0)) {
            Schedule.Task task = schedule.next(part.head().games());
            if (task == null && underWay == 0) {
                return null;
            }
            if (task == null) {
                wait();
                continue;
            }
            boolean ours = task.decision() % part.head().parts() == part.head().part() - 1;
            if (ours && !part.games().has(play.name(task, seats(task), 1))) {
                underWay++;
                return task;
            }
            schedule.over(task);
        }
        return null;
    }

    private List<Member> seats(Schedule.Task task) {
        return Arrays.stream(task.lineup()).mapToObj(members::get).toList();
    }

    /** @param mark of the programs, from before the game */
    private void play(Schedule.Task task, String mark) throws InterruptedException {
        try {
            List<StoredGame> attempts = play.play(new Elsewhere.Game(task, roster.settings(), seats(task), 1));
            if (isStored(task, attempts, mark)) {
                attempts.forEach(listener);
            }
        } catch (InputException problem) {
            stop(problem.getMessage());
        }
    }

    private boolean isStored(Schedule.Task task, List<StoredGame> attempts, String mark) {
        List<byte[]> kept = attempts.stream().map(game -> transcripts.remove(HexFormat.of().formatHex(game.name())))
            .toList();
        synchronized (this) {
            underWay--;
            notifyAll();
            if (!watch.isSince(mark)) {
                schedule.dropped(task);
                return false;
            }
            schedule.over(task);
            if (brokenOff || stopped != null) {
                return false;
            }
            part.add(attempts, kept);
            return true;
        }
    }

    /**
     * Breaks it off, from any thread: games that are under way are not stored.
     *
     * @return how many were under way
     */
    public synchronized int breakOff() {
        brokenOff = true;
        notifyAll();
        return underWay;
    }

    /** Returns why it ended before its time, or {@code null}. */
    public synchronized String stopped() {
        return stopped;
    }
}
