package steward.replay;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import steward.bot.Bot;
import steward.bot.InProcessPlayer;
import steward.bot.Player;
import steward.game.GameSetup;
import steward.game.GameTypes;
import steward.match.MatchResult;
import steward.match.Referee;
import steward.match.SeededBot;
import steward.match.TestScenes;
import steward.match.TimeControl;
import steward.replay.sign.SigningKey;
import steward.replay.verify.SignatureCheck;
import steward.replay.verify.Verification;

/**
 * A match played and recorded in memory.
 *
 * @param bytes  the replay
 * @param result what the referee said
 */
public record Recorded(byte[] bytes, MatchResult result) {

    /** Bots drawn by lot from the seed play a shipped scene; a third of the time they ram each other. */
    public static Recorded of(String scene, long seed) {
        return of(TestScenes.open(scene), seed, 0.3);
    }

    /** Bots drawn by lot from the seed play a scene. */
    public static Recorded of(GameSetup setup, long seed, double ramming) {
        List<Bot> bots = new ArrayList<>();
        for (int player = 0; player < setup.scene().players(); player++) {
            bots.add(new SeededBot(31 * seed + player, ramming));
        }
        return of(setup, seed, bots);
    }

    /** Given bots play a scene. */
    public static Recorded of(GameSetup setup, long seed, List<? extends Bot> bots) {
        return of(setup, seed, bots, null);
    }

    /** Records a match that is signed. */
    public static Recorded of(GameSetup setup, long seed, List<? extends Bot> bots, SigningKey key) {
        List<Player> players = new ArrayList<>();
        List<String> names = new ArrayList<>();
        for (Bot bot : bots) {
            names.add("P" + players.size());
            players.add(new InProcessPlayer("P" + players.size(), bot));
        }
        return ofPlayers(setup, seed, players, names, key);
    }

    /** Given players play a scene. */
    public static Recorded ofPlayers(GameSetup setup, long seed, List<? extends Player> players,
                                     List<String> names) {
        return ofPlayers(setup, seed, players, names, null);
    }

    private static Recorded ofPlayers(GameSetup setup, long seed, List<? extends Player> players, List<String> names,
                                      SigningKey key) {
        ByteArrayOutputStream file = new ByteArrayOutputStream();
        ReplayHeader header = new ReplayHeader(setup.scene().gameId(), setup.scene().json(), seed, names, names,
            Double.POSITIVE_INFINITY).ofLaw(setup.plan().lawVersion());
        try (ReplayWriter writer = new ReplayWriter(file, header, key, null)) {
            MatchResult result = new Referee(setup, seed, players, TimeControl.UNLIMITED, writer).play();
            return new Recorded(file.toByteArray(), result);
        } catch (InterruptedException nobodyDoes) {
            throw new AssertionError(nobodyDoes);
        }
    }

    /** The replay as text. */
    public String text() {
        return new String(bytes, StandardCharsets.UTF_8);
    }

    /** The lines of the replay, without line ends. */
    public List<String> lines() {
        return text().lines().toList();
    }

    /** The replay without anything measured. */
    public String withoutTimes() {
        StringBuilder kept = new StringBuilder();
        for (String line : lines()) {
            kept.append(line.replaceAll(",\"times\":\\{[^}]*}}$", "}")).append('\n');
        }
        return kept.toString();
    }

    /** Returns the expected verification of a replay with so many turns, all of which agree, and its result. */
    public static Verification whole(int turns) {
        return new Verification(turns, turns, true, null, null, null, SignatureCheck.UNSIGNED);
    }

    public Verification verify() {
        return verify(bytes);
    }

    public static Verification verify(byte[] replay) {
        return verify(replay, TestScenes.TYPES);
    }

    public static Verification verify(byte[] replay, GameTypes types) {
        try (ReplayReader reader = reader(replay)) {
            return Verification.of(reader, types);
        }
    }

    public static Verification verify(String replay) {
        return verify(replay.getBytes(StandardCharsets.UTF_8));
    }

    public static ReplayReader reader(byte[] replay) {
        return new ReplayReader(new ByteArrayInputStream(replay), "r.jsonl");
    }
}
