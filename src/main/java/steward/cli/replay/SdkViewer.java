package steward.cli.replay;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.ProviderNotFoundException;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.ExecutionException;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import steward.cli.shared.FailedException;
import steward.cli.shared.Pages;
import steward.cli.streams.EnterKey;
import steward.cli.streams.Streams;
import steward.files.InputException;
import steward.files.Resources;
import steward.live.StatusServer;
import steward.replay.RecordedMatch;
import steward.replay.RecordedTurn;
import steward.replay.ReplayReader;
import tools.jackson.core.JacksonException;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/**
 * Viewer of CodinGame's SDK with a recorded match in it. Its files are the folders {@code view} on the class path that
 * the replay names, the project's own first. Files that the SDK's runner would add are written here: the list of
 * assets, and an empty demonstration.
 */
final class SdkViewer {

    private static final JsonMapper JSON = new JsonMapper();
    private static final String VIEW = "view";
    private static final String ASSETS = "assets/";
    private static final Pattern IMPORT = Pattern.compile("(?m)^\\s*import\\b[^'\"]*['\"]\\./([^'\"]+)['\"]");
    private static final Pattern IMAGE = Pattern.compile("(?i).*\\.(png|jpe?g|svg)");
    private static final Pattern PLAYER = Pattern.compile("\\d{1,2}");
    /** A grey square: the viewer wants a picture of each player. */
    private static final String AVATAR = "data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAAAAAA6fptVAAAACklE"
        + "QVR4nGNoAAAAggCBd81ytgAAAABJRU5ErkJggg==";

    private final RecordedMatch match;
    private final byte[] start;
    /** Folders {@code view} in folders and jars. */
    private final List<Path> roots = new ArrayList<>();

    /** @throws InputException if the match has no such viewer, or one that is not compiled */
    SdkViewer(ReplayReader replay) {
        match = RecordedMatch.read(replay);
        start = replay.start();
        JsonNode entries = JSON.readTree(match.header().scene()).path("referee").path("classPath");
        entries.forEach(entry -> addRoot(Path.of(entry.asString()).normalize()));
        for (String needed : List.of("player.js", "player.html", "core/Drawer.js", "config.js")) {
            require(needed,
                entries.isEmpty() ? "the match is of no referee on a class path" : "its class path has none");
        }
        Matcher imported = IMPORT.matcher(new String(file("config.js"), StandardCharsets.UTF_8));
        while (imported.find()) {
            require(imported.group(1), "config.js imports it: the project's graphics are not compiled");
        }
    }

    private void addRoot(Path entry) {
        try {
            Path root = Files.isRegularFile(entry) ? FileSystems.newFileSystem(entry).getPath("/") : entry;
            if (Files.isDirectory(root.resolve(VIEW))) {
                roots.add(root.resolve(VIEW));
            }
        } catch (IOException | ProviderNotFoundException problem) {
            throw unreadable(entry, problem);
        }
    }

    /** Serves it until Enter, or the end of the input. */
    void serve(Streams streams, boolean open) throws InterruptedException {
        try (StatusServer server = StatusServer.ofViewer(page(), this::file)) {
            streams.out().println("Watch the match at");
            streams.out().println(server.address());
            streams.out().println("Enter ends.");
            streams.out().flush();
            if (open) {
                Pages.open(streams, server.address());
            }
            EnterKey.pressed(streams).get();
        } catch (IOException | ExecutionException problem) {
            throw new FailedException("--viewer: cannot be served: " + problem.getMessage());
        }
    }

    private void require(String name, String why) {
        if (file(name) == null) {
            throw new InputException("--viewer: found no view/" + name + ", " + why);
        }
    }

    /** Returns a file of the viewer, or {@code null}. */
    byte[] file(String name) {
        byte[] found = find(name);
        return found != null ? found : switch (name) {
            case "assets.js" -> ("export const assets = " + assets() + ";").getBytes(StandardCharsets.UTF_8);
            case "demo.js" -> "export const demo = null;".getBytes(StandardCharsets.UTF_8);
            default -> null;
        };
    }

    private byte[] find(String name) {
        for (Path root : roots) {
            Path file = root.resolve(name);
            try {
                if (Files.isRegularFile(file) && file.toRealPath().startsWith(root.toRealPath())) {
                    return Files.readAllBytes(file);
                }
            } catch (IOException problem) {
                throw unreadable(root, problem);
            }
        }
        return null;
    }

    private static InputException unreadable(Path path, Exception problem) {
        return new InputException("--viewer: cannot read " + path + " of the class path: " + problem.getMessage());
    }

    /** Images by name, sheets of sprites, and fonts; the images of sheets come with these. */
    private ObjectNode assets() {
        ObjectNode assets = JSON.createObjectNode().put("baseUrl", "/" + ASSETS);
        ObjectNode images = assets.putObject("images");
        ArrayNode sprites = assets.putArray("sprites");
        ArrayNode fonts = assets.putArray("fonts");
        Set<String> names = names();
        Set<String> ofSheets = new TreeSet<>();
        for (String name : names) {
            JsonNode sheet = name.endsWith(".json") ? json(file(ASSETS + name)) : JSON.nullNode();
            if (sheet.has("frames")) {
                sprites.add(name);
                ofSheets.add(Path.of(name).resolveSibling(sheet.path("meta").path("image").asString("")).toString());
            } else if (name.endsWith(".fnt")) {
                fonts.add(name);
            }
        }
        names.stream().filter(name -> IMAGE.matcher(name).matches() && !ofSheets.contains(name))
            .forEach(name -> images.put(name, name));
        return assets;
    }

    /** A file that is no JSON is no sheet of sprites. */
    private static JsonNode json(byte[] bytes) {
        try {
            return JSON.readTree(bytes);
        } catch (JacksonException other) {
            return JSON.nullNode();
        }
    }

    private Set<String> names() {
        Set<String> names = new TreeSet<>();
        for (Path root : roots) {
            Path folder = root.resolve(ASSETS);
            try (Stream<Path> files = Files.isDirectory(folder) ? Files.walk(folder) : Stream.empty()) {
                files.filter(Files::isRegularFile).forEach(file -> names.add(folder.relativize(file).toString()));
            } catch (IOException | UncheckedIOException problem) {
                throw unreadable(folder, problem);
            }
        }
        return names;
    }

    /** The page that shows the match in the viewer. */
    byte[] page() throws IOException {
        return Resources.text("/steward/viewer/page.html")
            .replace("MATCH", frames().toString().replace("<", "\\u003c")).getBytes(StandardCharsets.UTF_8);
    }

    /** Players and frames: a frame for each view, the last of a question with the answer. */
    private ObjectNode frames() {
        ObjectNode game = JSON.createObjectNode();
        ArrayNode agents = game.putArray("agents");
        for (int player = 0; player < match.header().names().size(); player++) {
            agents.addObject().put("index", player).put("name", match.header().names().get(player))
                .put("avatar", AVATAR).put("avatarUrl", AVATAR);
        }
        ArrayNode frames = game.putArray("frames");
        ArrayNode tooltips = game.putArray("tooltips");
        JsonNode state = JSON.readTree(start).path("state");
        for (RecordedTurn turn : match.turns()) {
            add(state, turn, frames, tooltips);
            state = JSON.readTree(turn.outcome()).path("state");
        }
        add(state, null, frames, tooltips);
        if (frames.isEmpty()) {
            throw new InputException("--viewer: found no block VIEW in the replay");
        }
        return game;
    }

    private static void add(JsonNode state, RecordedTurn answered, ArrayNode frames, ArrayNode tooltips) {
        ObjectNode frame = null;
        for (JsonNode block : state.path("said")) {
            List<String> lines = new ArrayList<>();
            block.path("lines").forEach(line -> lines.add(line.asString()));
            String text = String.join("\n", lines);
            switch (block.path("block").asString()) {
                case "VIEW" -> frame = frames.addObject().put("view", text.replaceFirst("^\\w+", ""))
                    .put("keyframe", text.startsWith("KEY_FRAME"));
                case "SUMMARY" -> put(frame, "gameSummary", text);
                case "TOOLTIP" -> {
                    for (int k = 0; k + 1 < lines.size(); k += 2) {
                        if (PLAYER.matcher(lines.get(k + 1).trim()).matches()) {
                            tooltips.add(JSON.createObjectNode().put("text", lines.get(k))
                                .put("event", Integer.parseInt(lines.get(k + 1).trim())).put("turn", frames.size() - 1)
                                .toString());
                        }
                    }
                }
                default -> { }
            }
        }
        int asked = state.path("asked").asInt(-1);
        if (answered != null && frame != null && asked >= 0 && asked < answered.stderr().length) {
            List<String> output = new ArrayList<>();
            JSON.readTree(answered.commands()).path(asked).path("lines").forEach(line -> output.add(line.asString()));
            put(frame.put("agentId", asked), "stdout", String.join("\n", output));
            put(frame, "stderr", answered.stderr()[asked]);
        }
    }

    private static void put(ObjectNode frame, String name, String text) {
        if (frame != null && text != null && !text.isEmpty()) {
            frame.put(name, text);
        }
    }
}
