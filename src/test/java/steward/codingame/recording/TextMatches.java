package steward.codingame.recording;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.function.UnaryOperator;
import steward.bot.InProcessPlayer;
import steward.bot.TestBots;
import steward.bot.process.BotProcess;
import steward.bots.BundledBotMatches;
import steward.bots.Racer;
import steward.game.GameSetup;
import steward.match.MatchResult;
import steward.match.Protocol;
import steward.match.Referee;
import steward.match.Seat;
import steward.match.TestScenes;
import steward.match.TimeControl;
import steward.replay.ReplayHeader;
import steward.replay.ReplayReader;
import steward.replay.ReplayWriter;
import steward.replay.verify.Verification;

/**
 * Matches between bots that speak lines and bots that speak JSON, recorded in memory.
 *
 * @param result what the referee said
 * @param replay the replay
 */
record TextMatches(MatchResult result, byte[] replay) {

    /** Plays a match. */
    static TextMatches play(GameSetup setup, long seed, TimeControl time, Seat... seats) {
        ByteArrayOutputStream file = new ByteArrayOutputStream();
        List<String> names = new ArrayList<>();
        List<Protocol> protocols = new ArrayList<>();
        for (Seat seat : seats) {
            names.add(seat.player().name());
            protocols.add(seat.protocol());
        }
        ReplayHeader header = new ReplayHeader(setup.scene().gameId(), setup.scene().json(), seed, names, names,
            protocols, Double.POSITIVE_INFINITY).ofLaw(setup.plan().lawVersion());
        try (ReplayWriter writer = new ReplayWriter(file, header)) {
            return new TextMatches(Referee.of(setup, seed, List.of(seats), time, writer).play(), file.toByteArray());
        } catch (InterruptedException nobodyDoes) {
            throw new AssertionError(nobodyDoes);
        }
    }

    MatchResult.PlayerResult player(int number) {
        return result.players().get(number);
    }

    String replayText() {
        return new String(replay, StandardCharsets.UTF_8);
    }

    Verification verify() {
        return verify(replay);
    }

    static Verification verify(byte[] replay) {
        try (ReplayReader reader = new ReplayReader(new ByteArrayInputStream(replay), "r.jsonl")) {
            return Verification.of(reader, TestScenes.TYPES);
        }
    }

    /** A program that speaks CodinGame's lines. */
    static Seat program(String name, List<String> command) {
        return new Seat(new BotProcess(name, command), Protocol.CODINGAME);
    }

    /** The bundled plain bot, which speaks JSON, inside this JVM. */
    static Seat racer() {
        return new Seat(new InProcessPlayer("racer", BundledBotMatches.asBot(new Racer())), Protocol.JSON);
    }

    /** A bot of CodinGame's lines inside this JVM: a function from the lines it is sent to its answer. */
    static Seat lines(String name, UnaryOperator<String> answers) {
        return new Seat(new InProcessPlayer(name, TestBots.answering(answers)), Protocol.CODINGAME);
    }
}
