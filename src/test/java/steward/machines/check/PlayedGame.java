package steward.machines.check;

import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import steward.bot.isolation.Isolation;
import steward.cli.shared.Games;
import steward.contest.Contest;
import steward.contest.Contest.Entrant;
import steward.contest.GameLog;
import steward.contest.repeat.GameFacts;
import steward.game.Game;
import steward.game.GameJson;
import steward.game.GameSetup;
import steward.game.Pilot;
import steward.match.DirectBot;
import steward.match.MatchResult;
import steward.match.Protocol;
import steward.match.Seat;
import steward.match.TeeListener;
import steward.numerics.SplitMix64;

/**
 * A game, as a replay and as a transcript.
 *
 * @param result that it had where it was played
 * @param facts  that were seen there
 */
record PlayedGame(Contest contest, ExpectedGame expected, byte[] replay, byte[] transcript,
                  MatchResult result, GameFacts facts) {

    static PlayedGame of(Contest contest, long seed) throws InterruptedException {
        ByteArrayOutputStream replay = new ByteArrayOutputStream();
        TranscriptWriter transcript = new TranscriptWriter(contest.entrants().stream().map(Entrant::bot).toList(),
            contest.sandbox());
        GameLog log = new GameLog(contest, 0);
        MatchResult result = contest.play(seed, 0, replay, new TeeListener(transcript, log));
        return new PlayedGame(contest, new ExpectedGame(seed,
            contest.entrants().stream().map(Entrant::name).toList(),
            contest.entrants().stream().map(Entrant::protocol).toList(),
            contest.limits(contest.entrants())), replay.toByteArray(), transcript.compressed(), result, log.facts());
    }

    CheckedGame check() throws DisprovedException {
        return new TranscriptCheck(contest).check("a game", transcript, expected);
    }

    /** Returns the disproof of the game with some text of the transcript replaced. */
    String disproof(String old, String text) throws Exception {
        String sent = new String(GzipText.bytes(transcript), StandardCharsets.UTF_8);
        assertTrue(sent.contains(old), () -> "found no '" + old + "' in " + sent);
        int at = sent.lastIndexOf(old);
        String changed = sent.substring(0, at) + text + sent.substring(at + old.length());
        byte[] bytes = GzipText.compressed(changed.getBytes(StandardCharsets.UTF_8));
        return assertThrows(DisprovedException.class,
            () -> new TranscriptCheck(contest).check("a game", bytes, expected)).getMessage();
    }

    /** Plays by a pilot, in this JVM. */
    private static final class PilotBot implements DirectBot {

        private final GameSetup setup;
        private final Pilot pilot;
        private final SplitMix64 random = new SplitMix64(11);
        private Game game;
        private GameJson codec;
        private int player;

        PilotBot(GameSetup setup, Pilot.Aim aim) {
            this.setup = setup;
            pilot = setup.pilot(aim);
        }

        @Override
        public void start(Game started, int number) {
            game = started;
            player = number;
            codec = setup.codec(game);
        }

        @Override
        public void turn() {
            byte[] answer = pilot.answer(game, player, random).getBytes(StandardCharsets.UTF_8);
            String wrong = codec.readAnswer(player, answer, answer.length);
            if (wrong != null) {
                throw new IllegalStateException(wrong);
            }
        }

        @Override
        public String message() {
            return player == 0 && game.turn() % 7 == 3 ? "\u00fcber \"all\" \ud83d\ude00" : null;
        }
    }

    /** Bots that play by a pilot, in this JVM. */
    static Contest piloted(String scene, Pilot.Aim aim) {
        GameSetup setup = Games.open(scene);
        List<Entrant> entrants = new ArrayList<>();
        for (int player = 0; player < setup.scene().players(); player++) {
            entrants.add(new Entrant("p" + player, "bot " + player, Protocol.JSON, List.of("none")));
        }
        return Contest.withoutBots(setup, Double.POSITIVE_INFINITY).between(entrants).isolatedBy(() -> Isolation.OFF)
            .startedBy((entrant, isolation, others) ->
                Seat.direct(entrant.name(), new PilotBot(setup, aim)).player());
    }
}
