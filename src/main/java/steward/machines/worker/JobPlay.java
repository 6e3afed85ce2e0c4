package steward.machines.worker;

import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import steward.bot.command.BotCommand;
import steward.bot.command.Program;
import steward.bot.isolation.Isolation;
import steward.contest.Attempts;
import steward.contest.Contest;
import steward.contest.Contest.Entrant;
import steward.contest.GameLog;
import steward.contest.Hiccups;
import steward.files.InputException;
import steward.game.GameSetup;
import steward.game.GameTypes;
import steward.machines.bundle.UnpackedBundle;
import steward.machines.check.GameJar;
import steward.machines.check.RulesFingerprint;
import steward.machines.check.TranscriptWriter;
import steward.machines.wire.GameJob;
import steward.machines.wire.HeaderText;
import steward.machines.wire.LeagueWord;
import steward.machines.wire.WorkerWord;
import steward.match.MatchResult;
import steward.match.Protocol;
import steward.match.TeeListener;

/** Play of a league's jobs on a worker, with the league's scene and limits and the fetched bots. Thread-safe. */
final class JobPlay {

    /** Bytes of a report to which no more games are added. */
    private static final long LARGE = 1 << 20;
    /** After so long no other game of a job is begun, in nanoseconds. */
    private static final long LONG_NANOS = TimeUnit.SECONDS.toNanos(1);
    private static final int LONGEST_TEXT = 500;

    private final Contest contest;
    private final Hiccups hiccups;
    private final Path folder;
    private final String platform;
    private final Map<String, Entrant> bots = new ConcurrentHashMap<>();

    /** Brings the bytes of a bundle. */
    interface Fetcher {
        byte[] fetch(String bundle, int size) throws Exception;
    }

    /** The league's program computes other results. */
    static final class OtherRulesException extends Exception {

        private final String field;
        private final String own;

        OtherRulesException(String message, String field, String own) {
            super(message);
            this.field = field;
            this.own = own;
        }

        /** Returns the answer to the league. */
        HeaderText word() {
            return new HeaderText().put("type", "differs").put(field, own);
        }
    }

    /** A bot that does not run here. */
    static final class UnfitException extends Exception {

        private final String bundle;

        UnfitException(String bundle, String message) {
            super(message);
            this.bundle = bundle;
        }

        String bundle() {
            return bundle;
        }
    }

    /**
     * Takes what the league says of its games.
     *
     * @param folder   where bundles go
     * @param platform that this machine is
     * @throws InputException      if it cannot be used
     * @throws OtherRulesException if the league's program computes other results in this scene
     */
    JobPlay(LeagueWord.Welcome welcome, GameTypes types, Supplier<Isolation> isolation, Path folder, String platform,
            String version) throws OtherRulesException {
        hiccups = welcome.hiccups();
        String theirs = welcome.version();
        String rules = welcome.rules();
        if (welcome.jar() != null) {
            String jar = GameJar.installed(types, welcome.scene());
            if (!jar.equals(welcome.jar())) {
                throw new OtherRulesException(GameJar.missing(jar, welcome.jar()), "jar", jar);
            }
        }
        GameSetup setup = types.open(welcome.scene(), "the league's scene");
        String own = RulesFingerprint.of(setup);
        if (!own.equals(rules)) {
            throw new OtherRulesException("found Steward " + theirs + " (results " + rules + ") in the league and "
                + "Steward " + version + " (results " + own + ") here, expected versions that compute the same",
                "rules", own);
        }
        contest = Contest.withoutBots(setup, welcome.factor()).limitedBy(welcome.basis())
            .isolatedBy(() -> isolation.get().holding(welcome.hold()));
        this.folder = folder;
        this.platform = platform;
    }

    /**
     * Plays a job.
     *
     * @param begins asked before each game whether it may begin
     * @return what came of the games that were begun
     * @throws UnfitException if a bot does not run here; no game has been begun then
     */
    WorkerWord.Result play(GameJob job, Fetcher fetcher, BooleanSupplier begins) throws Exception {
        List<Contest> matches = new ArrayList<>();
        for (GameJob.Game game : job.games()) {
            List<Entrant> entrants = new ArrayList<>();
            for (GameJob.Seat seat : game.seats()) {
                entrants.add(entrant(seat, fetcher).named(seat.name()).within(seat.limits()));
            }
            if (entrants.size() != contest.players()) {
                throw new InputException("found a game of " + entrants.size() + " seats, expected "
                    + contest.players());
            }
            matches.add(contest.between(entrants));
        }
        List<WorkerWord.Played> games = new ArrayList<>();
        long bytes = 0;
        long began = System.nanoTime();
        while (games.size() < matches.size() && bytes < LARGE && System.nanoTime() - began < LONG_NANOS
            && begins.getAsBoolean()) {
            WorkerWord.Played played = play(matches.get(games.size()), job.games().get(games.size()).seed());
            bytes += played.transcripts().stream().mapToLong(each -> each.length).sum();
            games.add(played);
        }
        return new WorkerWord.Result(job.id(), games);
    }

    private WorkerWord.Played play(Contest match, long seed) throws InterruptedException {
        List<byte[]> transcripts = new ArrayList<>();
        List<Boolean> starved = new ArrayList<>();
        String problem = null;
        Attempts attempts = new Attempts(match, hiccups, 0);
        boolean again = true;
        while (again) {
            GameLog log = new GameLog(match, 0);
            TranscriptWriter transcript = new TranscriptWriter(match.entrants().stream().map(Entrant::bot).toList(),
                contest.sandbox());
            MatchResult result = null;
            try {
                result = attempts.contest().play(seed, 0, null, new TeeListener(transcript, log));
            } catch (UncheckedIOException failed) {
                problem = shortened(String.valueOf(failed.getMessage()));
            }
            again = result != null && attempts.demandAnother(log.failures());
            transcripts.add(transcript.compressed());
            starved.add(again);
        }
        String discarded = attempts.discarded() == null ? null : shortened(attempts.discarded());
        return new WorkerWord.Played(transcripts, starved, problem, discarded);
    }

    /** A text as it fits into a header. */
    static String shortened(String text) {
        return text.length() > LONGEST_TEXT ? text.substring(0, LONGEST_TEXT) : text;
    }

    private synchronized Entrant entrant(GameJob.Seat seat, Fetcher fetcher) throws Exception {
        Entrant known = bots.get(seat.bundle());
        if (known != null) {
            return known;
        }
        UnpackedBundle unpacked;
        Program program;
        try {
            unpacked = UnpackedBundle.of(folder, seat.bundle(), fetcher.fetch(seat.bundle(), seat.size()), platform);
            program = unpacked.program();
        } catch (InputException problem) {
            throw new UnfitException(seat.bundle(), seat.name() + ": " + problem.getMessage());
        }
        Protocol protocol = unpacked.command().prefix() == BotCommand.Prefix.CODINGAME ? Protocol.CODINGAME
            : Protocol.JSON;
        Entrant entrant = new Entrant(seat.name(), unpacked.command().toString(), protocol, program, null);
        String problem = BotTrial.problem(contest, entrant.within(seat.limits()));
        if (problem != null) {
            throw new UnfitException(seat.bundle(), seat.name() + " does not run here: " + problem);
        }
        bots.put(seat.bundle(), entrant);
        return entrant;
    }
}
