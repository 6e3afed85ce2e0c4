package steward.machines.worker;

import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Supplier;
import steward.bot.command.BotCommand;
import steward.bot.isolation.Isolation;
import steward.contest.BotStarter;
import steward.contest.Contest;
import steward.contest.Contest.Entrant;
import steward.contest.Failure;
import steward.contest.GameLog;
import steward.contest.Hiccups;
import steward.files.InputException;
import steward.game.GameSetup;
import steward.game.GameTypes;
import steward.machines.bundle.UnpackedBundle;
import steward.machines.check.RulesFingerprint;
import steward.machines.check.TranscriptWriter;
import steward.machines.wire.GameJob;
import steward.machines.wire.HeaderText;
import steward.machines.wire.LeagueWord;
import steward.machines.wire.WireMessage;
import steward.match.MatchResult;
import steward.match.Protocol;
import steward.match.TeeListener;

/** Plays jobs of a league: its scene and limits, and the bots that have been fetched. Thread-safe. */
final class JobPlay {

    private final Contest contest;
    private final Hiccups hiccups;
    private final Path folder;
    private final Map<String, Entrant> bots = new ConcurrentHashMap<>();

    /** Brings the bytes of a bundle. */
    interface Fetcher {
        byte[] fetch(String bundle, int size) throws Exception;
    }

    /** The league's program computes other results. */
    static final class OtherRulesException extends Exception {

        private static final long serialVersionUID = 1;

        private final String own;

        OtherRulesException(String message, String own) {
            super(message);
            this.own = own;
        }

        String own() {
            return own;
        }
    }

    /** A bot that does not run here. */
    static final class UnfitException extends Exception {

        private static final long serialVersionUID = 1;

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
     * @param folder  where bundles go
     * @param version of this program
     * @param starter starts bots, or {@code null} for programs
     * @throws InputException      if it cannot be used
     * @throws OtherRulesException if the league's program computes other results in this scene
     */
    JobPlay(LeagueWord.Welcome welcome, GameTypes types, Supplier<Isolation> isolation, Path folder, String version,
            BotStarter starter) throws OtherRulesException {
        hiccups = welcome.hiccups();
        String theirs = welcome.version();
        String rules = welcome.rules();
        GameSetup setup = types.open(welcome.scene(), "the league's scene");
        String own = RulesFingerprint.of(setup);
        if (!own.equals(rules)) {
            throw new OtherRulesException("found Steward " + theirs + " (results " + rules + ") in the league and "
                + "Steward " + version + " (results " + own + ") here, expected versions that compute the same", own);
        }
        Contest usual = Contest.withoutBots(setup, welcome.factor()).limitedBy(welcome.basis())
            .isolatedBy(isolation);
        contest = starter == null ? usual : usual.startedBy(starter);
        this.folder = folder;
    }

    /**
     * Plays a job.
     *
     * @return the report for the league
     * @throws UnfitException if a bot does not run here
     */
    byte[] play(GameJob job, Fetcher fetcher) throws Exception {
        List<Entrant> entrants = new ArrayList<>();
        for (GameJob.Seat seat : job.seats()) {
            entrants.add(entrant(seat, fetcher).named(seat.name()));
        }
        if (entrants.size() != contest.players()) {
            throw new InputException("found a job of " + entrants.size() + " seats, expected " + contest.players());
        }
        List<HeaderText> sizes = new ArrayList<>();
        List<byte[]> transcripts = new ArrayList<>();
        String problem = null;
        for (int attempt = 1; attempt <= 2 && problem == null; attempt++) {
            Contest match = contest.between(entrants);
            GameLog log = new GameLog(match, 0);
            TranscriptWriter transcript = new TranscriptWriter(entrants.stream().map(Entrant::bot).toList(),
                contest.sandbox());
            MatchResult result = null;
            try {
                result = match.play(job.seed(), 0, null, new TeeListener(transcript, log));
            } catch (UncheckedIOException failed) {
                problem = String.valueOf(failed.getMessage());
            }
            boolean again = attempt == 1 && result != null && hiccups == Hiccups.REPLAY
                && log.failures().stream().anyMatch(Failure::starved);
            byte[] sent = transcript.compressed();
            sizes.add(new HeaderText().put("size", sent.length).put("starved", again));
            transcripts.add(sent);
            if (!again) {
                break;
            }
        }
        return WireMessage.bytes(new HeaderText().put("type", "result").put("job", job.id()).put("attempts", sizes)
            .put("problem", problem), transcripts.toArray(byte[][]::new));
    }

    private synchronized Entrant entrant(GameJob.Seat seat, Fetcher fetcher) throws Exception {
        Entrant known = bots.get(seat.bundle());
        if (known != null) {
            return known;
        }
        UnpackedBundle unpacked;
        try {
            unpacked = UnpackedBundle.of(folder, seat.bundle(), fetcher.fetch(seat.bundle(), seat.size()));
        } catch (InputException problem) {
            throw new UnfitException(seat.bundle(), seat.name() + ": " + problem.getMessage());
        }
        Protocol protocol = unpacked.command().prefix() == BotCommand.Prefix.CODINGAME ? Protocol.CODINGAME
            : Protocol.JSON;
        Entrant entrant = new Entrant(seat.name(), unpacked.command().toString(), protocol, unpacked.words());
        String problem = BotTrial.problem(contest, entrant);
        if (problem != null) {
            throw new UnfitException(seat.bundle(), seat.name() + " does not run here: " + problem);
        }
        bots.put(seat.bundle(), entrant);
        return entrant;
    }
}
