package steward.minigame;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
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
import steward.match.TimeControl;
import steward.replay.ReplayHeader;
import steward.replay.ReplayReader;
import steward.replay.ReplayWriter;
import steward.replay.verify.Verification;

/** Opens the pond's scene and plays recorded matches in it. */
final class PondMatches {

    static final GameTypes TYPES = new GameTypes(List.of(new PondType()));

    private PondMatches() {
    }

    /** A match that was played: its replay and its result. */
    record Played(byte[] replay, MatchResult result) {

        String text() {
            return new String(replay, StandardCharsets.UTF_8);
        }

        /** Without what was measured. */
        String withoutTimes() {
            return text().replaceAll("(?m),\"times\":.*$", "");
        }
    }

    /** The scene with some texts, each of which must be there, replaced. */
    static GameSetup changed(String... fromTo) {
        String text = scene();
        for (int k = 0; k < fromTo.length; k += 2) {
            if (!text.contains(fromTo[k])) {
                throw new IllegalArgumentException("no " + fromTo[k]);
            }
            text = text.replace(fromTo[k], fromTo[k + 1]);
        }
        return TYPES.open(text, "pond.json");
    }

    private static String scene() {
        try (InputStream in = PondMatches.class.getResourceAsStream("/minigame/pond.json")) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException problem) {
            throw new UncheckedIOException(problem);
        }
    }

    static Played play(GameSetup setup, long seed, List<? extends Bot> bots) throws InterruptedException {
        List<Player> players = new ArrayList<>();
        List<String> names = new ArrayList<>();
        for (Bot bot : bots) {
            names.add("bot" + names.size());
            players.add(new InProcessPlayer(names.get(names.size() - 1), bot));
        }
        ByteArrayOutputStream file = new ByteArrayOutputStream();
        ReplayHeader header = new ReplayHeader("pond", setup.scene().json(), seed, names, names,
            Double.POSITIVE_INFINITY).ofLaw(setup.plan().lawVersion());
        try (ReplayWriter writer = new ReplayWriter(file, header)) {
            MatchResult result = new Referee(setup, seed, players, TimeControl.UNLIMITED, writer).play();
            return new Played(file.toByteArray(), result);
        }
    }

    static Verification verify(byte[] replay) {
        try (ReplayReader reader = new ReplayReader(new ByteArrayInputStream(replay), "pond.jsonl")) {
            return Verification.of(reader, TYPES);
        }
    }
}
