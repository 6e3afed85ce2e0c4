package steward.bots;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Properties;
import java.util.Set;
import org.junit.jupiter.api.Test;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** The bundled bots as programs: lines in, lines out, and when they end. */
class BotProgramTest {

    private static final String SETUP = "{\"type\":\"setup\",\"game\":\"pod-race\",\"player\":1,\"players\":2,"
        + "\"news\":{\"deep\":[1,{\"x\":2}]},\"podsPerPlayer\":1,\"laps\":1,"
        + "\"checkpoints\":[{\"x\":5500,\"y\":3000,\"z\":1},{\"x\":10500,\"y\":3500},{\"x\":7500,\"y\":6300}],"
        + "\"checkpointRadius\":600,\"podRadius\":400,\"podMass\":1,\"minimumImpulse\":120,\"drag\":0.15,"
        + "\"maximumThrust\":200,\"boostThrust\":650,\"field\":{\"width\":16000,\"height\":9000,\"walls\":true,"
        + "\"colour\":\"blue\",\"bumpers\":[{\"x\":8000,\"y\":5000,\"radius\":400,\"soft\":null}]}}\n";
    private static final String TURN = "{\"type\":\"turn\",\"turn\":1,\"turnsLeft\":50,\"wind\":[[1],[2]],\"pods\":["
        + "{\"id\":0,\"player\":0,\"x\":5550,\"y\":2502,\"vx\":0,\"vy\":0,\"heading\":null,\"nextCheckpoint\":1,"
        + "\"lap\":0},{\"id\":1,\"player\":1,\"x\":5450,\"y\":3498,\"vx\":0,\"vy\":0,\"heading\":12.5,"
        + "\"nextCheckpoint\":1,\"lap\":0,\"shieldTimer\":0,\"boostLeft\":true,\"paint\":{\"x\":7}}]}\n";
    private static final String END = "{\"type\":\"end\",\"player\":1,\"turns\":1,\"ranks\":[0,1]}\n";

    @Test
    void everyTurnLineGetsOneAnswerLineAndUnknownFieldsAreSkipped() throws IOException {
        for (PodBot bot : new PodBot[] {new Racer(), new Regular(), new Contender(), new Veteran()}) {
            String[] answers = run(bot, SETUP + TURN + TURN + END).split("\n");
            assertEquals(2, answers.length);
            assertTrue(answers[0].startsWith("{\"pods\":[{\"x\":"), answers[0]);
        }
    }

    @Test
    void thePlainBotSteersAtItsNextCheckpoint() throws IOException {
        // Heading 12.5 degrees, checkpoint 1 at atan2(2, 5050) = 0.02 degrees: little to turn, much thrust.
        assertAims(10500, 3500, 150, 200, run(new Racer(), SETUP + TURN));
    }

    @Test
    void theRegularAimsAgainstItsDrift() throws IOException {
        // Three turns of (100, -20) off checkpoint 1: (10200, 3560), seen from (5450, 3498) at atan2(62, 4750) = 0.75
        // degrees. The heading is 12.5 degrees.
        assertAims(10200, 3560, 150, 200, run(new Regular(), SETUP + drifting(5450, 100, -20)));
    }

    /**
     * The pod at x = 9200 coasts by 400 and 340 u and so into checkpoint 1 (from x = 9900) within two turns. The
     * regular still thrusts at it; the contender has tried what comes after, and turns to checkpoint 2 at once, by 18
     * degrees and with the engine off.
     * <pre>
     *      pod -&gt;   (1)        heading 12.5 degrees; y grows downwards
     *
     *          (2)
     * </pre>
     */
    @Test
    void theContenderTurnsToTheCheckpointAfterInTime() throws IOException {
        assertAims(9300, 3500, 150, 200, run(new Regular(), SETUP + drifting(9200, 400, 0)));
        // 30.5 degrees, 10000 u away: (9200 + 8616, 3498 + 5075).
        assertAims(17816, 8573, 0, 0, run(new Contender(), SETUP + drifting(9200, 400, 0)));
    }

    private static void assertAims(int x, int y, int leastThrust, int mostThrust, String answer) {
        JsonNode pod = JsonMapper.shared().readTree(answer).get("pods").get(0);
        assertEquals(List.of(x, y), List.of(pod.get("x").intValue(), pod.get("y").intValue()));
        int thrust = pod.get("thrust").intValue();
        assertTrue(thrust >= leastThrust && thrust <= mostThrust, answer);
    }

    /** The turn with the pod at another place and in motion. */
    private static String drifting(int x, int vx, int vy) {
        String still = "\"x\":5450,\"y\":3498,\"vx\":0,\"vy\":0";
        return TURN.replace(still, "\"x\":" + x + ",\"y\":3498,\"vx\":" + vx + ",\"vy\":" + vy);
    }

    @Test
    void nothingIsReadBehindTheEndLine() throws IOException {
        InputStream in = new ByteArrayInputStream((SETUP + END + TURN).getBytes(StandardCharsets.UTF_8));
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        new Veteran().run(in, out);
        assertEquals(0, out.size());
    }

    @Test
    void linesMayArriveInPieces() throws IOException {
        byte[] bytes = (SETUP + TURN + TURN + END).getBytes(StandardCharsets.UTF_8);
        InputStream pieces = new ByteArrayInputStream(bytes) {
            @Override
            public synchronized int read(byte[] into, int offset, int length) {
                return super.read(into, offset, Math.min(length, 7));
            }
        };
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        new Veteran().run(pieces, out);
        assertEquals(run(new Veteran(), SETUP + TURN + TURN + END), out.toString(StandardCharsets.UTF_8));
    }

    @Test
    void calledWithLinesABotAnswersAsItDoesAsAProgram() throws IOException {
        Veteran bot = new Veteran();
        bot.setup(SETUP.strip());
        assertEquals(run(new Veteran(), SETUP + TURN), bot.turn(TURN.strip()) + "\n");
    }

    @Test
    void theListOfBuiltinBotsNamesMainClasses() throws Exception {
        Properties list = new Properties();
        try (InputStream in = Racer.class.getResourceAsStream("builtin.properties")) {
            list.load(in);
        }
        assertEquals(Set.of("racer", "regular", "contender", "veteran", "driver", "coaster", "planner", "gatherer",
            "harvester", "marauder", "chaser", "striker", "captain", "nibbler", "grazer", "glutton"),
            list.stringPropertyNames());
        for (String name : list.stringPropertyNames()) {
            Class.forName(list.getProperty(name).replaceFirst(".* ", "")).getMethod("main", String[].class);
        }
    }

    private static String run(PodBot bot, String lines) throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        bot.run(new ByteArrayInputStream(lines.getBytes(StandardCharsets.UTF_8)), out);
        return out.toString(StandardCharsets.UTF_8);
    }
}
