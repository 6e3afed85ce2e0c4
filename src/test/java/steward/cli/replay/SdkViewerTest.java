package steward.cli.replay;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.OutputStream;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.net.http.HttpResponse.BodyHandlers;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.jar.JarEntry;
import java.util.jar.JarOutputStream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import steward.cli.Cli;
import steward.live.StatusServer;
import steward.replay.ReplayReader;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** The viewer of a referee on the SDK, by a player of ours in a jar and a project of one module. */
class SdkViewerTest {

    private static final String GRAPHICS = "target/classes/view/graphics/View.js";

    @TempDir
    private Path folder;
    private Path replay;

    @BeforeEach
    void write() throws IOException {
        Path jar = folder.resolve("player.jar");
        try (OutputStream file = Files.newOutputStream(jar); JarOutputStream out = new JarOutputStream(file)) {
            for (Map.Entry<String, String> entry : Map.of("player.js", "// ours", "player.html", "<p>ours",
                    "core/Drawer.js", "// draws", "config.js", "// of the jar", "assets/over.png", "jar").entrySet()) {
                out.putNextEntry(new JarEntry("view/" + entry.getKey()));
                out.write(entry.getValue().getBytes());
            }
        }
        put("target/classes/view/config.js", "import { View } from './graphics/View.js'\n");
        put(GRAPHICS, "export class View {}");
        put("target/classes/view/assets/sheet.json", "{\"frames\": {}, \"meta\": {\"image\": \"sheet.png\"}}");
        put("target/classes/view/assets/sheet.png", "sheet");
        put("target/classes/view/assets/letters.fnt", "font");
        put("target/classes/view/assets/broken.json", "{bad");
        put("target/classes/secret.txt", "secret");
        Files.createSymbolicLink(folder.resolve("target/classes/view/leak.txt"),
            folder.resolve("target/classes/secret.txt"));
        replay = folder.resolve("match.jsonl");
        Files.writeString(replay, """
            {"type":"steward-replay","format":3,"angles":"correctly-rounded","game":"guest","seed":"3","players":[\
            {"name":"<one","bot":"codingame:a","protocol":"codingame"},\
            {"name":"two","bot":"codingame:b","protocol":"codingame"}],"timeFactor":1,\
            "scene":{"name":"small","game":"guest","players":2,"referee":{"classPath":["CLASSES","JAR"]}},\
            "drawing":{"field":{"x":0,"y":0,"width":1600,"height":900},"walls":[],"zones":[],"bodies":[]},\
            "start":{"state":{"bodies":[],"asked":1,"said":[{"block":"VIEW","lines":["KEY_FRAME 0","{\\"a\\":1}"]},\
            {"block":"SUMMARY","lines":["$1 begins"]},{"block":"VIEW","lines":["INTERMEDIATE_FRAME 1"]}]},\
            "hash":"0000000000000001"},"headerHash":"0000000000000001"}
            {"type":"turn","turn":1,"commands":[null,{"lines":["WAIT","AND SEE"]}],"outcome":{"state":{"bodies":[],\
            "said":[{"block":"VIEW","lines":["KEY_FRAME 2","{}"]},\
            {"block":"TOOLTIP","lines":["late","1","odd","none"]}]},\
            "hash":"0000000000000002"},"stderr":[null,"thinking"],"turnHash":"0000000000000002"}
            """.replace("CLASSES", folder.resolve("target/../target/classes").toString())
            .replace("JAR", jar.toString()));
    }

    private void put(String name, String text) throws IOException {
        Path file = folder.resolve(name);
        Files.createDirectories(file.getParent());
        Files.writeString(file, text);
    }

    private static HttpResponse<String> get(StatusServer server, String path) throws Exception {
        URI address = server.address().resolve("/" + path);
        return HttpClient.newHttpClient().send(HttpRequest.newBuilder(address).build(), BodyHandlers.ofString());
    }

    @Test
    void thePlayerOfTheJarsIsServedWithTheProjectOverIt() throws Exception {
        try (ReplayReader reader = ReplayReader.open(replay)) {
            SdkViewer viewer = new SdkViewer(reader);
            try (StatusServer server = StatusServer.ofViewer(viewer.page(), viewer::file)) {
                assertEquals("// ours", get(server, "player.js").body());
                HttpResponse<String> config = get(server, "config.js");
                assertTrue(config.body().contains("View"), config.body());
                assertEquals("text/javascript; charset=utf-8", config.headers().firstValue("Content-Type").get());
                assertEquals("*", config.headers().firstValue("Access-Control-Allow-Origin").get());
                assertTrue(config.headers().firstValue("Content-Security-Policy").get().contains("default-src 'self'"));
                assertEquals("export const demo = null;", get(server, "demo.js").body());
                assertEquals("export const assets = {\"baseUrl\":\"/assets/\",\"images\":{\"over.png\":\"over.png\"},"
                    + "\"sprites\":[\"sheet.json\"],\"fonts\":[\"letters.fnt\"]};", get(server, "assets.js").body());
                assertEquals(404, get(server, "nothing.js").statusCode());
                assertEquals(404, get(server, "%2e%2e/secret.txt").statusCode());
                assertEquals(404, get(server, "../secret.txt").statusCode());
                assertEquals(404, get(server, "leak.txt").statusCode());
                assertEquals(404, get(server, "a%00b").statusCode());
                assertEquals(404, get(server, "%2fetc/hostname").statusCode());
            }
        }
    }

    @Test
    void thePageHasAFrameForEachViewAndIsReadByNobodyElse() throws Exception {
        try (ReplayReader reader = ReplayReader.open(replay)) {
            SdkViewer viewer = new SdkViewer(reader);
            assertEquals(null, viewer.file("../secret.txt"));
            try (StatusServer server = StatusServer.ofViewer(viewer.page(), viewer::file)) {
                HttpResponse<String> page = get(server, "");
                assertFalse(page.headers().firstValue("Access-Control-Allow-Origin").isPresent());
                String json = page.body().replaceFirst("(?s).*id=\"match\">", "").replaceFirst("(?s)</script>.*", "");
                assertFalse(json.contains("<"), json);
                JsonNode match = new JsonMapper().readTree(json);
                assertEquals("<one", match.at("/agents/0/name").asString());
                assertEquals("[{\"view\":\" 0\\n{\\\"a\\\":1}\",\"keyframe\":true,\"gameSummary\":\"$1 begins\"},"
                    + "{\"view\":\" 1\",\"keyframe\":false,\"agentId\":1,\"stdout\":\"WAIT\\nAND SEE\","
                    + "\"stderr\":\"thinking\"},{\"view\":\" 2\\n{}\",\"keyframe\":true}]",
                    match.get("frames").toString());
                assertEquals("{\"text\":\"late\",\"event\":1,\"turn\":2}", match.at("/tooltips/0").asString());
            }
        }
    }

    @Test
    void withoutCompiledGraphicsItSaysSo() throws IOException {
        Files.delete(folder.resolve(GRAPHICS));
        Cli.run("replay", replay.toString(), "--viewer").assertRefused("--viewer: found no view/graphics/View.js, "
            + "config.js imports it: the project's graphics are not compiled");
        Files.writeString(folder.resolve("player.jar"), "no jar");
        Cli.run("replay", replay.toString(), "--viewer").assertRefused("--viewer: cannot read "
            + folder.resolve("player.jar") + " of the class path: zip END header not found");
        Files.writeString(replay, Files.readString(replay).replace("classPath", "command"));
        Cli.run("replay", replay.toString(), "--viewer").assertRefused("--viewer: found no view/player.js, the match "
            + "is of no referee on a class path");
    }
}
