package steward.lab.capacity;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import steward.contest.Contest;
import steward.contest.Contest.Entrant;
import steward.machines.check.AnswerCheck;
import steward.machines.check.DisprovedException;
import steward.machines.check.ExpectedGame;
import steward.machines.check.TranscriptCheck;
import steward.machines.check.TranscriptWriter;
import steward.match.MatchResult;
import steward.match.Protocol;
import steward.replay.RecordedMatch;

/**
 * Cost of checking a game, by itself on one thread.
 *
 * @param check microseconds of CPU time in which a game is unpacked and played again
 * @param again the same in which its bots are asked again, the bots' own time included
 * @param turns of a game, on average
 * @param bytes of a game as it is sent, on average
 */
public record CheckPrices(double check, double again, double turns, double bytes) {

    /** Different games in rotation. */
    private static final int GAMES = 50;
    private static final double NANOS = 1e9;
    private static final double NANOS_PER_US = 1e3;

    private record Sent(ExpectedGame expected, byte[] transcript, int turns) { }

    /** Something that is done with a game. */
    private interface Work {
        void run(Sent game) throws DisprovedException;
    }

    /** Measures for so many seconds of CPU time each, after half as many that do not count. */
    public static CheckPrices measure(MeasuredBots bots, double seconds) throws InterruptedException {
        List<Entrant> entrants = IntStream.rangeClosed(1, bots.setup().scene().players()).mapToObj(k ->
            new Entrant("bot-" + k, bots.command(k), Protocol.JSON, List.of("none"))).toList();
        Contest contest = bots.contest().between(entrants);
        List<Sent> games = new ArrayList<>();
        for (int seed = 0; seed < GAMES; seed++) {
            games.add(played(contest.startedBy(bots.playing()), seed));
        }
        TranscriptCheck check = new TranscriptCheck(contest);
        AnswerCheck answers = new AnswerCheck(contest.startedBy(bots.asked()), bots.types());
        double checked = micros(games, seconds, game -> check.check("a game", game.transcript(), game.expected()));
        double again = micros(games, seconds, game -> {
            RecordedMatch match = check.match("a game", game.transcript(), game.expected());
            for (int seat = 0; seat < entrants.size(); seat++) {
                answers.check(match, seat, entrants.get(seat));
            }
        });
        return new CheckPrices(checked, again, games.stream().mapToInt(Sent::turns).average().orElseThrow(),
            games.stream().mapToInt(game -> game.transcript().length).average().orElseThrow());
    }

    private static Sent played(Contest contest, long seed) throws InterruptedException {
        TranscriptWriter transcript = new TranscriptWriter(contest.entrants().stream().map(Entrant::bot).toList(),
            contest.sandbox());
        MatchResult result = contest.play(seed, 0, null, transcript);
        return new Sent(new ExpectedGame(seed, contest.entrants().stream().map(Entrant::name).toList(),
            contest.entrants().stream().map(Entrant::protocol).toList()), transcript.compressed(), result.turns());
    }

    private static double micros(List<Sent> games, double seconds, Work work) {
        measured(games, seconds / 2, work);
        return measured(games, seconds, work);
    }

    private static double measured(List<Sent> games, double seconds, Work work) {
        ThreadMXBean threads = ManagementFactory.getThreadMXBean();
        long began = threads.getCurrentThreadCpuTime();
        long count = 0;
        long cpu = 0;
        do {
            for (Sent game : games) {
                try {
                    work.run(game);
                } catch (DisprovedException problem) {
                    throw new IllegalStateException("a game that was just played: " + problem.getMessage(), problem);
                }
            }
            count += games.size();
            cpu = threads.getCurrentThreadCpuTime() - began;
        } while (cpu < seconds * NANOS);
        return cpu / NANOS_PER_US / count;
    }
}
