package steward.game.podrace.vectors;

import java.util.regex.Matcher;
import java.util.regex.Pattern;
import steward.game.Comparison;
import steward.game.VectorMatch;
import steward.game.podrace.PodState;
import steward.game.podrace.Races;
import steward.game.podrace.Recordings;
import steward.game.podrace.RulesEdition;
import steward.game.podrace.simulator.CppHeader;
import steward.game.podrace.simulator.PodCommands;
import steward.game.podrace.simulator.PodRaceSimulator;
import tools.jackson.databind.JsonNode;

/** The turns of a match in which no player fails or is out, played by the simulator from the recorded state before. */
final class SimulatedVectors {

    private static final Pattern LINE = Pattern.compile("(-?[0-9]+) (-?[0-9]+) (SHIELD|[0-9]+)( .*)?");

    private final VectorMatch match;
    private final Comparison comparison;
    private final CppHeader header;
    private int turns;

    /** @param header plays the turns of four pods too; {@code null} for none */
    SimulatedVectors(VectorMatch match, CppHeader header) {
        this.match = match;
        this.header = match.header().get("players").asInt() == 2 && match.header().get("podsPerPlayer").asInt() == 2
            ? header : null;
        comparison = new Comparison(match.name() + " (simulator)");
    }

    int turns() {
        return turns;
    }

    Comparison compare() {
        PodRaceSimulator race = new PodRaceSimulator(PodRaceReplay.checkpoints(match),
            match.header().get("players").asInt(), match.header().get("podsPerPlayer").asInt(),
            match.header().get("laps").asInt(), RulesEdition.CONTEST);
        PodCommands commands = new PodCommands(race.pods());
        JsonNode before = match.start();
        if (header != null) {
            header.map(PodRaceReplay.checkpoints(match), RulesEdition.CONTEST);
        }
        for (JsonNode turn : match.turns()) {
            before = turn.has("before") ? turn.get("before") : before;
            if (set(race, before) && nobodyIsOut(turn.get("state")) && read(commands, turn.get("commands"))) {
                if (header != null) {
                    header.state(race);
                }
                race.play(commands);
                if (header != null) {
                    header.turn(commands, race, PodRaceReplay.checkpoints(match).length);
                }
                turns++;
                compare("turn " + turn.get("turn").asInt(), race, turn.get("state"));
            }
            before = turn.get("state");
        }
        return comparison;
    }

    private boolean set(PodRaceSimulator race, JsonNode state) {
        for (JsonNode pod : state.get("pods")) {
            Races.put(race, pod.get("id").asInt(), PodRaceReplay.state(pod));
        }
        for (JsonNode player : state.get("players")) {
            race.setTurnsLeft(player.get("id").asInt(), player.get("turnsLeft").asInt());
        }
        return nobodyIsOut(state);
    }

    private static boolean nobodyIsOut(JsonNode state) {
        for (JsonNode player : state.get("players")) {
            if (!player.get("out").isNull()) {
                return false;
            }
        }
        return true;
    }

    private boolean read(PodCommands commands, JsonNode answers) {
        int pod = 0;
        for (JsonNode answer : answers) {
            if (!answer.isArray() || answer.size() != match.header().get("podsPerPlayer").asInt()) {
                return false;
            }
            for (JsonNode line : answer) {
                Matcher words = LINE.matcher(line.asString());
                if (!words.matches()) {
                    return false;
                }
                Recordings.Command command = Recordings.command(words.group(1), words.group(2), words.group(3));
                if (command.thrust() > 200) {
                    return false;
                }
                commands.set(pod++, command.x(), command.y(), command.thrust());
            }
        }
        return true;
    }

    private void compare(String when, PodRaceSimulator race, JsonNode state) {
        for (JsonNode recorded : state.get("pods")) {
            int id = recorded.get("id").asInt();
            String what = when + " pod " + id + " ";
            PodState of = PodRaceReplay.state(recorded);
            comparison.same(what + "x", of.x(), race.x(id));
            comparison.same(what + "y", of.y(), race.y(id));
            comparison.same(what + "vx", of.vx(), race.vx(id));
            comparison.same(what + "vy", of.vy(), race.vy(id));
            comparison.same(what + "heading", of.heading(), race.heading(id));
            comparison.same(what + "shield timer", of.shieldTimer(), race.shieldTimer(id));
            comparison.same(what + "passed", of.passed(), race.passed(id));
            comparison.same(what + "next", recorded.get("next").asInt(), race.nextCheckpoint(id));
        }
        for (JsonNode player : state.get("players")) {
            int id = player.get("id").asInt();
            if (player.get("out").isNull()) {
                comparison.same(when + " player " + id + " turns left", player.get("turnsLeft").asInt(),
                    race.turnsLeft(id));
            }
        }
    }
}
