package steward.machines.serve;

import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.Semaphore;
import java.util.function.Consumer;
import steward.bot.FaultMessages;
import steward.contest.Contest;
import steward.contest.Hiccups;
import steward.files.InputException;
import steward.game.GameTypes;
import steward.league.GameName;
import steward.league.LeagueFolder;
import steward.league.Schedule;
import steward.league.Season;
import steward.league.StoredGame;
import steward.league.StoredGame.StoredSeat;
import steward.league.play.KeptGames;
import steward.league.play.RemoteMachines;
import steward.league.play.Roster.Member;
import steward.machines.check.AnswerCheck;
import steward.machines.check.AskedAgain;
import steward.machines.check.CheckedGame;
import steward.machines.check.DisprovedException;
import steward.machines.check.ExpectedGame;
import steward.machines.check.GzipText;
import steward.machines.check.TranscriptCheck;
import steward.machines.wire.WorkerWord;
import steward.replay.RecordedMatch;

/** Games that workers report: transcripts that become stored games, or are disproved. Thread-safe. */
final class ReportedGames {

    /** Memory that one check may take, in bytes: the longest transcript, its last line, and what is read of it. */
    private static final long MOST_MEMORY = 4L * GzipText.LONGEST;

    private final LeagueFolder folder;
    private final Season season;
    private final Contest contest;
    /** Checks by the factor of a worker's time limits besides the league's own, in steps of a hundredth. */
    private final Map<Double, TranscriptCheck> transcripts = new ConcurrentHashMap<>();
    private final AnswerCheck answers;
    private final AskedAgain askedAgain;
    private final KeptGames keeper;
    /** A worker may send hundreds of the longest transcripts at once: no more are unpacked than there is room for. */
    private final Semaphore room = new Semaphore((int) Math.max(1, Math.min(Runtime.getRuntime().availableProcessors(),
        Runtime.getRuntime().maxMemory() / (2 * MOST_MEMORY))));

    ReportedGames(LeagueFolder folder, Season season, Contest contest, GameTypes types, Consumer<String> teller,
                  AskedAgain.Suspecter suspecter) {
        this.folder = folder;
        this.season = season;
        this.contest = contest;
        answers = new AnswerCheck(contest, types);
        askedAgain = new AskedAgain(teller, suspecter);
        keeper = new KeptGames(folder);
    }

    private TranscriptCheck transcripts(double scale) {
        return transcripts.computeIfAbsent(scale, by -> new TranscriptCheck(by == 1 ? contest
            : Contest.withoutBots(contest.setup(), by * contest.timeFactor()).limitedBy(contest.time().basis())));
    }

    /**
     * The attempts at a game as their transcripts tell them.
     *
     * @param machine where they were played
     * @param scale   of the worker's time limits, besides the league's own
     * @param nanos   that the worker had the game, at most
     * @throws DisprovedException if it was not so
     */
    List<StoredGame> attempts(RemoteMachines.Game game, WorkerWord.Played played, String machine, double scale,
                              long nanos) throws DisprovedException, InterruptedException {
        List<StoredGame> attempts = new ArrayList<>();
        long[] left = {nanos};
        room.acquire();
        try {
            for (int k = 0; k < played.transcripts().size(); k++) {
                attempts.add(attempt(game, played, machine, transcripts(scale), k, left));
            }
        } catch (DisprovedException wrong) {
            attempts.forEach(attempt -> KeptGames.remove(folder, attempt));
            throw wrong;
        } finally {
            room.release();
        }
        return attempts;
    }

    private StoredGame attempt(RemoteMachines.Game game, WorkerWord.Played played, String machine,
                               TranscriptCheck check, int k, long... left) throws DisprovedException {
        Schedule.Task task = game.task();
        List<Member> members = game.members();
        byte[] sent = played.transcripts().get(k);
        byte[] name = GameName.of(season, task.seed(),
            members.stream().map(member -> member.version().identity()).toList(), game.first() + k);
        String source = "game " + HexFormat.of().formatHex(name);
        CheckedGame outcome = check.check(source, sent, expected(game));
        left[0] -= outcome.nanos();
        if (left[0] < 0) {
            throw new DisprovedException(source + ": found answers that took " + outcome.nanos() / 1000
                + " us, expected no more than the time since the worker was handed the game");
        }
        boolean last = k == played.transcripts().size() - 1;
        boolean starved = played.starved().get(k);
        boolean late = outcome.seats().stream().anyMatch(seat -> seat.fault() != null
            && FaultMessages.isTime(seat.fault()));
        boolean discarded = last && played.discarded() != null;
        if (discarded && (!late || k + 1 < WorkerWord.MOST_ATTEMPTS)) {
            throw new DisprovedException(source + ": found a result that is not to count in attempt " + (k + 1)
                + (late ? "" : ", in which nobody was late") + ", expected that only after "
                + WorkerWord.MOST_ATTEMPTS + " attempts lost on time");
        }
        if (last ? starved : !late || !starved || game.settings().hiccups() != Hiccups.REPLAY) {
            throw new DisprovedException(source + ": found attempt " + (k + 1) + " of " + played.transcripts().size()
                + (late ? "" : ", in which nobody was late") + ", expected another only for one lost on time");
        }
        List<StoredSeat> seats = new ArrayList<>();
        for (int seat = 0; seat < members.size(); seat++) {
            CheckedGame.Seat told = outcome.seats().get(seat);
            seats.add(new StoredSeat(members.get(seat).version().id(), told.rank(), told.score(), told.fault(),
                told.answers(), told.meanNanos(), told.worstNanos(), told.firstNanos(),
                outcome.facts().values(seat)));
        }
        String file = null;
        List<String> names = members.stream().map(member -> member.bot().name()).toList();
        if (KeptGames.keeps(game.settings(), true, seats, names)) {
            file = keeper.take(name, check.replay(source, sent, expected(game)), true);
        }
        return new StoredGame(0, name, task.decision(), task.seed(), game.first() + k, last && !discarded,
            outcome.turns(), discarded ? LeagueTerms.shown(played.discarded()) : null,
            System.currentTimeMillis(), machine, file, outcome.facts().transcript(), seats);
    }

    private ExpectedGame expected(RemoteMachines.Game game) {
        return new ExpectedGame(game.task().seed(),
            game.members().stream().map(member -> member.entrant().name()).toList(),
            game.members().stream().map(member -> member.entrant().protocol()).toList(),
            contest.limits(game.members().stream().map(Member::entrant).toList()));
    }

    /**
     * Asks bots again what they were asked, those that do not draw by lot.
     *
     * @param worker that has played the game
     * @param scale  of its time limits
     * @param sent   the transcript of the last attempt, compressed
     */
    void askAgain(RemoteMachines.Game game, String worker, double scale, byte[] sent)
            throws DisprovedException, InterruptedException {
        String source = "game of seed " + game.task().seed();
        RecordedMatch match;
        room.acquire();
        try {
            match = transcripts(scale).match(source, sent, expected(game));
        } finally {
            room.release();
        }
        for (int seat = 0; seat < game.members().size(); seat++) {
            Member member = game.members().get(seat);
            if (member.playsHere() && !member.bot().random() && !member.version().random()) {
                int player = seat;
                askedAgain.ask(member.version().display(), worker, () -> asked(match, player, member));
            }
        }
    }

    private AnswerCheck.Otherwise asked(RecordedMatch match, int player, Member member) {
        try {
            return answers.difference(match, player, member.entrant());
        } catch (InputException problem) {
            return new AnswerCheck.Otherwise(problem.getMessage(), true);
        }
    }

    /** What is doubtful of a worker by the answers of its bots, a sentence each. */
    List<String> doubts(String worker) {
        return askedAgain.doubts(worker);
    }
}
