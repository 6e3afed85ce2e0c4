package steward.replay;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Set;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import steward.cli.shared.Games;
import steward.game.Game;
import steward.game.GameJson;
import steward.game.GameSetup;
import steward.game.Pilot;
import steward.game.bodies.protocol.BodiesJson;
import steward.game.fantasticbits.protocol.FantasticBitsJson;
import steward.game.podrace.protocol.PodRaceJson;
import steward.json.JsonObject;
import steward.numerics.SplitMix64;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** States are read into the records of their games with every field, and with no other. */
class StatesTest {

    private static final int TURNS = 60;

    private static RecordedTurn turn(Game game, GameJson codec) {
        byte[] outcome = JsonObject.of(out -> {
            out.writeObjectPropertyStart("state");
            codec.writeState(out);
            out.writeEndObject();
        });
        return new RecordedTurn(game.turn(), new byte[0], new String[0], "", outcome, new String[0], new String[0],
            null, "match.jsonl:" + (game.turn() + 1));
    }

    /** Fields that are there, written by the game and from the record, with equal values; the names are collected. */
    private static void compare(JsonNode written, JsonNode read, String where, Set<String> names) {
        if (written.isNumber()) {
            assertEquals(written.doubleValue(), read.doubleValue(), where);
        } else if (written.isObject()) {
            Set<String> there = new TreeSet<>(written.propertyNames());
            read.propertyStream().filter(field -> !field.getValue().isNull())
                .forEach(field -> there.add(field.getKey()));
            for (String name : there) {
                names.add(where.replaceAll("[0-9]+", "") + name);
                assertTrue(written.has(name) && read.has(name), () -> where + name);
                compare(written.get(name), read.get(name), where + name + ".", names);
            }
        } else {
            assertEquals(written.size(), read.size(), where);
            assertTrue(written.isArray() || written.equals(read), where);
            for (int k = 0; k < written.size(); k++) {
                compare(written.get(k), read.get(k), where + k + ".", names);
            }
        }
    }

    private static Set<String> play(String scene) {
        GameSetup setup = Games.open(scene);
        Game game = setup.create(3);
        GameJson codec = setup.codec(game);
        Pilot pilot = setup.pilot(Pilot.Aim.WIN);
        SplitMix64 random = new SplitMix64(3);
        JsonMapper mapper = JsonMapper.shared();
        Set<String> names = new TreeSet<>();
        Class<? extends Record> type = Arrays.stream(codec.getClass().getDeclaredClasses())
            .filter(each -> each.getSimpleName().equals("State")).findFirst().orElseThrow().asSubclass(Record.class);
        while (!game.isOver() && game.turn() < TURNS) {
            for (int player = 0; player < game.players(); player++) {
                byte[] answer = pilot.answer(game, player, random).getBytes(StandardCharsets.UTF_8);
                codec.readAnswer(player, answer, answer.length);
            }
            game.play();
            RecordedTurn turn = turn(game, codec);
            Record state = turn.state(type);
            assertNotNull(state);
            compare(mapper.readTree(turn.outcome()).get("state"), mapper.valueToTree(state), "", names);
        }
        return names;
    }

    @ParameterizedTest
    @ValueSource(strings = {"mad-pod-racing", "mean-max", "fantastic-bits", "poker-chip-race", "search-race", "cradle"})
    void aStateIsReadAsItIsWritten(String scene) {
        assertTrue(play(scene).contains("bodies..x"));
    }

    @Test
    void whatOnlySomeBodiesHaveIsRead() {
        assertTrue(play("fantastic-bits").contains("bodies..spells..turns"));
        assertTrue(play("mean-max").contains("bodies..spawnedFor"));
    }

    @Test
    void theStateOfAnotherGameIsRefusedWithItsPlace() {
        GameSetup setup = Games.open("mad-pod-racing");
        Game game = setup.create(1);
        RecordedTurn turn = turn(game, setup.codec(game));

        assertEquals(4, turn.state(PodRaceJson.State.class).bodies().size());
        String message = assertThrows(ReplayException.class, () -> turn.state(FantasticBitsJson.State.class))
            .getMessage();
        assertTrue(message.startsWith("match.jsonl:1: outcome: state"), message);
        assertTrue(message.endsWith("expected a state of FantasticBitsJson"), message);
    }

    /** A disc of one's own game, or one that was changed by hand. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
        {} | state.bodies: found nothing
        {"bodies": []} | state.points: found nothing
        {"points": [1], "bodies": [{"id": 1.7, "x": 3, "y": 1, "vx": 1, "vy": 1}]} | state.bodies[0].id: found
        {"points": [1.5], "bodies": []} | state.points[0]: found
        {"points": [], "bodies": [{"id": 1, "x": "3", "y": 1, "vx": 1, "vy": 1}]} | state.bodies[0].x: found
        {"points": [], "bodies": [{"id": 1, "x": 3, "y": 0}]} | state.bodies[0]: found null or nothing for a number
        {"points": [], "bodies": [{"id": 1, "x": 3, "y": 1, "vx": 1, "vy": 1, "mass": 3}]} | state.bodies[0].mass: found
        {"points": [], "bodies": [], "points": [1]} | state: found Duplicate
        """)
    void whatIsNoStateOfTheGameIsRefusedWithItsPlace(String state, String said) {
        byte[] outcome = ("{\"state\": " + state + "}").getBytes(StandardCharsets.UTF_8);
        RecordedTurn turn = new RecordedTurn(1, new byte[0], new String[0], "", outcome, new String[0], new String[0],
            null, "match.jsonl:2");
        String message = assertThrows(ReplayException.class, () -> turn.state(BodiesJson.State.class)).getMessage();
        assertTrue(message.startsWith("match.jsonl:2: outcome: " + said), message);
    }

    @Test
    void fieldsMayComeInAnyOrder() {
        RecordedTurn turn = new RecordedTurn(1, new byte[0], new String[0], "", """
            {"state": {"points": [4], "bodies": [{"vy": 4, "x": 1, "y": 2, "vx": 3, "id": 7}]}}"""
            .getBytes(StandardCharsets.UTF_8), new String[0], new String[0], null, "match.jsonl:2");
        assertEquals(new BodiesJson.Disc(7, 1, 2, 3, 4), turn.state(BodiesJson.State.class).bodies().get(0));
    }
}
