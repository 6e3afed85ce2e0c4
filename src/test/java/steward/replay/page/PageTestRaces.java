package steward.replay.page;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import steward.bot.Player;
import steward.game.GameSetup;
import steward.game.GameTypes;
import steward.game.podrace.protocol.PodRaceType;
import steward.match.Referee;
import steward.match.TimeControl;
import steward.replay.ReplayHeader;
import steward.replay.ReplayWriter;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** Plays whole pod races of {@link PageTestBot}s and gives their replays. */
public final class PageTestRaces {

    private PageTestRaces() {
    }

    /** The text of a scene that comes with the project. */
    public static String scene(String name) {
        try {
            return Files.readString(Path.of("config", "scenes", name + ".json"));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** A replay, as bytes, of one race. */
    public static byte[] play(String scene, long seed) {
        return play(scene, seed, List.of("swift", "steady"));
    }

    static byte[] play(String scene, long seed, List<String> names) {
        GameSetup setup = new GameTypes(List.of(new PodRaceType())).open(scene, "scene");
        List<Player> players = new ArrayList<>();
        for (String name : names) {
            players.add(PageTestBot.player(name, new PageTestBot()));
        }
        String used = JsonMapper.shared().readTree(scene).toString();
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        ReplayHeader header = new ReplayHeader("pod-race", used, seed, names,
            names.stream().map(name -> "./" + name).toList(), 1);
        try (ReplayWriter writer = new ReplayWriter(bytes, header)) {
            new Referee(setup, seed, players, TimeControl.UNLIMITED, writer).play();
        } catch (InterruptedException e) {
            throw new IllegalStateException(e);
        }
        return bytes.toByteArray();
    }

    /** The lines of a replay, parsed: header, turns, result. */
    static List<JsonNode> lines(byte[] replay) {
        return new String(replay, StandardCharsets.UTF_8).lines().map(JsonMapper.shared()::readTree).toList();
    }
}
