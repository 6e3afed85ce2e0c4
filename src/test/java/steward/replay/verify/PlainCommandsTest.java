package steward.replay.verify;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import steward.cli.shared.Games;
import steward.game.Game;
import steward.game.GameJson;
import steward.game.GameSetup;
import steward.game.Pilot;
import steward.json.JsonNumbers;
import steward.numerics.SplitMix64;
import steward.replay.RecordedTurn;
import tools.jackson.core.JacksonException;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.JsonParser;
import tools.jackson.core.JsonToken;
import tools.jackson.core.ObjectWriteContext;

/** The fast reader of recorded commands accepts only what the full one accepts, and reads it to the same bit. */
class PlainCommandsTest {

    private static final long SEED = 22;
    private static final int TURNS = 20_000;
    private static final List<String> INSERTED = List.of("", "0", "-", ".", " ", ",", "}", "]", "\"", "e1", "\t", "\n",
        "null", "x", "[", "{\"x\":1,");

    private final SplitMix64 random = new SplitMix64(SEED);

    @ParameterizedTest
    @ValueSource(strings = {"mad-pod-racing", "walled-race"})
    @Tag("slow")
    void readsWhatTheFullReaderReads(String scene) {
        GameSetup setup = Games.open(scene);
        Resimulation fast = new Resimulation(setup, SEED);
        Resimulation full = new Resimulation(setup, SEED);
        int plain = 0;
        for (int k = 0; k < TURNS; k++) {
            if (k == TURNS / 2) {
                fast.game().eliminate(0, "out");
                full.game().eliminate(0, "out");
            }
            String sound = turn(full.game());
            String text = k % 2 == 0 ? sound : damaged(sound);
            String where = scene + ", seed " + SEED + ", turn " + k + ": " + text;
            byte[] json = ("..." + text + "...").getBytes(StandardCharsets.UTF_8);
            String before = commands(fast);
            int behind = fast.preparePlain(json, 3, json.length - 3);
            if (behind >= 0) {
                plain++;
                assertEquals(behind - 3, readByTheParser(full, text), where);
                assertEquals(commands(full), commands(fast), where);
            } else if (firstIsDamaged(full, text)) {
                assertEquals(before, commands(fast), where);
            }
        }
        assertTrue(plain > TURNS / 5 && plain < TURNS / 2, "plain turns: " + plain);
    }

    private String turn(Game game) {
        StringBuilder text = new StringBuilder("[");
        for (int player = 0; player < game.players(); player++) {
            text.append(player == 0 ? "" : ",").append(!game.isIn(player) ? "null" : "[" + pod() + "," + pod() + "]");
        }
        return text.append(random.nextInt(8) == 0 ? "] ]" : "]").toString();
    }

    private String pod() {
        String blank = random.nextInt(9) == 0 ? " " : "";
        String third = switch (random.nextInt(12)) {
            case 0 -> "\"shield\":" + blank + "true";
            case 1 -> "\"boost\":true" + blank;
            case 2 -> "\"thrust\":" + random.nextInt(200);
            case 3 -> "\"thrust\":" + random.nextInt(100) + ".0";
            case 4 -> "\"thrust\":" + random.nextInt(100) + (random.nextInt(4) == 0 ? ",\"more\":1" : "");
            default -> "\"thrust\":" + random.nextInt(101);
        };
        return "{\"x\":" + number() + blank + ",\"y\":" + blank + number() + "," + third + "}";
    }

    private String number() {
        String whole = (random.nextInt(2) == 0 ? "-" : "") + (random.nextLong() >>> 15 + random.nextInt(49));
        return switch (random.nextInt(60)) {
            case 0 -> whole + "." + (random.nextLong() >>> 1 + random.nextInt(62));
            case 1 -> whole + ".000" + random.nextInt(100);
            case 2 -> "0." + "0".repeat(random.nextInt(14)) + random.nextInt(1000);
            case 3 -> random.nextLong() + "";
            case 4 -> whole + "e" + random.nextInt(4);
            case 5 -> "-0";
            default -> whole;
        };
    }

    private String damaged(String text) {
        int at = random.nextInt(text.length());
        String inserted = INSERTED.get(random.nextInt(INSERTED.size()));
        String rest = random.nextInt(6) == 0 ? "" : text.substring(at + random.nextInt(2));
        return text.substring(0, at) + inserted + rest;
    }

    /** Reads a turn by the parser. @return the place behind it, or -1 if it is not one */
    private static int readByTheParser(Resimulation game, String text) {
        GameJson codec = game.codec();
        byte[] json = text.getBytes(StandardCharsets.UTF_8);
        try (JsonParser in = RecordedTurn.parser(json)) {
            if (in.nextToken() != JsonToken.START_ARRAY) {
                return -1;
            }
            for (int player = 0; player < game.game().players(); player++) {
                JsonToken token = in.nextToken();
                boolean right = game.game().isIn(player) ? codec.readCommand(in, player) == null
                    : token == JsonToken.VALUE_NULL;
                if (!right) {
                    return -1;
                }
            }
            return in.nextToken() == JsonToken.END_ARRAY ? (int) in.currentLocation().getByteOffset() : -1;
        } catch (JacksonException noJson) {
            return -1;
        }
    }

    /** True if already the first command that is expected is not plain. */
    private static boolean firstIsDamaged(Resimulation game, String text) {
        byte[] json = text.getBytes(StandardCharsets.UTF_8);
        int player = game.game().isIn(0) ? 0 : 1;
        int from = player == 0 ? 1 : "[null,".length();
        return from >= json.length || game.codec().readPlainCommand(json, from, json.length, player) < 0;
    }

    private static String commands(Resimulation game) {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (JsonGenerator out = JsonNumbers.FACTORY.createGenerator(ObjectWriteContext.empty(), bytes)) {
            for (int player = 0; player < game.game().players(); player++) {
                if (game.game().isIn(player)) {
                    game.codec().writeCommand(out, player);
                }
            }
        }
        return bytes.toString(StandardCharsets.UTF_8);
    }

    /** Otherwise it would save no time. */
    @Test
    void acceptsWhatTheGameWrites() {
        GameSetup setup = Games.open("mad-pod-racing");
        for (Pilot.Aim aim : Pilot.Aim.values()) {
            Resimulation fast = new Resimulation(setup, SEED);
            Resimulation full = new Resimulation(setup, SEED);
            Pilot pilot = setup.pilot(aim);
            while (!full.game().isOver()) {
                byte[] json = written(full, pilot);
                assertEquals(json.length, fast.preparePlain(json, 0, json.length), aim + ", seed " + SEED);
                assertEquals(commands(full), commands(fast));
                full.game().play();
                fast.game().play();
                assertEquals(full.game().hash(), fast.game().hash());
            }
        }
    }

    private byte[] written(Resimulation game, Pilot pilot) {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (JsonGenerator out = JsonNumbers.FACTORY.createGenerator(ObjectWriteContext.empty(), bytes)) {
            out.writeStartArray();
            for (int player = 0; player < game.game().players(); player++) {
                byte[] answer = pilot.answer(game.game(), player, random).getBytes(StandardCharsets.UTF_8);
                assertNull(game.codec().readAnswer(player, answer, answer.length));
                game.codec().writeCommand(out, player);
            }
            out.writeEndArray();
        }
        return bytes.toByteArray();
    }
}
