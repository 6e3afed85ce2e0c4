package steward.league.play;

import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.List;
import java.util.function.LongSupplier;
import java.util.stream.IntStream;
import steward.bot.command.BotCommand;
import steward.bot.isolation.Isolation;
import steward.bot.isolation.SandboxLevel;
import steward.contest.Attempts;
import steward.contest.Contest;
import steward.contest.GameLog;
import steward.files.InputException;
import steward.league.GameName;
import steward.league.LeagueBot;
import steward.league.LeagueSettings;
import steward.league.Schedule;
import steward.league.Season;
import steward.league.StoredGame;
import steward.league.StoredGame.StoredSeat;
import steward.league.play.Roster.Member;
import steward.match.MatchListener;
import steward.match.MatchResult;

/**
 * Play of one game of the schedule, repeated if the game was lost on time because others used the processors.
 *
 * @param contest    of the scene, its limits and isolation
 * @param recordings where replays go
 * @param machine    what is noted with each game
 * @param clock      milliseconds since 1970
 */
public record GamePlay(Season season, Contest contest, Recordings recordings, String machine, LongSupplier clock) {

    /** Destination of the recordings of games that are over. */
    public interface Recordings {

        /** Returns what records the next attempt at a game. */
        Recorder recorder(LeagueSettings settings);

        /**
         * Takes a recording.
         *
         * @param game  its name
         * @param kept  whether the settings say that it is kept
         * @return its path in the folder of replays, or {@code null}
         * @throws InputException if it cannot be written
         */
        String take(byte[] game, byte[] recording, boolean kept);
    }

    /** Plays an attempt and records it. */
    public interface Recorder {

        /** Plays, see {@link Contest#play}. */
        MatchResult play(Contest match, long seed, MatchListener log) throws InterruptedException;

        /** The recording, of a game without a result as far as it came; {@code null} if there is none. */
        byte[] recording();
    }

    /**
     * Plays.
     *
     * @return the attempts, of which the last one counts if it has a result
     * @throws InputException if the replay cannot be written
     */
    public List<StoredGame> play(RemoteMachines.Game game) throws InterruptedException {
        Schedule.Task task = game.task();
        LeagueSettings settings = game.settings();
        List<Member> members = game.members();
        List<StoredGame> attempts = new ArrayList<>();
        Contest match = contest.between(members.stream().map(Member::entrant).toList())
            .isolatedBy(() -> isolation(settings));
        Attempts plan = new Attempts(match, settings.hiccups(), 0);
        boolean again = true;
        while (again) {
            GameLog log = new GameLog(match, 0);
            Recorder recorder = recordings.recorder(settings);
            MatchResult result = null;
            String problem = null;
            try {
                result = recorder.play(plan.contest(), task.seed(), log);
            } catch (UncheckedIOException failed) {
                problem = String.valueOf(failed.getMessage());
            }
            again = result != null && plan.demandAnother(log.failures());
            attempts.add(stored(task, settings, members, game.first() + attempts.size(), result,
                plan.discarded() != null ? plan.discarded() : problem, !again && plan.discarded() == null, log,
                recorder.recording()));
        }
        return attempts;
    }

    /** At strict no bot sees the files of another bot of the league, whoever plays. */
    private Isolation isolation(LeagueSettings settings) {
        Isolation isolation = contest.staging().isolation().get();
        if (isolation.level() != SandboxLevel.STRICT) {
            return isolation;
        }
        return isolation.hidingFilesOf(settings.active().stream()
            .filter(bot -> bot.parsed().prefix() != BotCommand.Prefix.BUILTIN).map(LeagueBot::program).toList());
    }

    private StoredGame stored(Schedule.Task task, LeagueSettings settings, List<Member> members, int attempt,
                              MatchResult result, String problem, boolean last, GameLog log,
                              byte... recording) {
        byte[] name = name(task, members, attempt);
        List<StoredSeat> seats = IntStream.range(0, members.size())
            .mapToObj(seat -> StoredSeat.of(members.get(seat).version().id(), result, seat, log.facts().values(seat)))
            .toList();
        List<String> names = members.stream().map(member -> member.bot().name()).toList();
        String replay = recording == null ? null : recordings.take(name, recording,
            KeptGames.keeps(settings, result != null, seats, names));
        return new StoredGame(0, name, task.decision(), task.seed(), attempt, last && result != null,
            result == null ? 0 : result.turns(), problem, clock.getAsLong(), machine, replay,
            log.facts().transcript(), seats);
    }

    /** The game's name. */
    public byte[] name(Schedule.Task task, List<Member> members, int attempt) {
        return GameName.of(season, task.seed(), members.stream().map(member -> member.version().identity()).toList(),
            attempt);
    }
}
