package steward.codingame.recording;

import java.util.Arrays;
import java.util.List;
import steward.game.Game;
import steward.game.podrace.PodRace;
import steward.game.podrace.PodRaceSettings;
import steward.json.JsonNumbers;
import steward.json.JsonObject;
import tools.jackson.core.JsonGenerator;

/**
 * Observations of a game by CodinGame's server, in the form of a replay. Of the shield it shows only the turn in which
 * it was raised, of the boost nothing, of the checkpoints the next one: timers, boosts and passed checkpoints are
 * counted here. Its counters are those of a race that goes on: before the first turn all players have rank 1, and those
 * of the last turn are left out.
 */
final class ObservedGame implements ServerObservations {

    private final GameRecording recording;
    private final int[] passed = new int[GameRecording.PODS];
    private final int[] next = new int[GameRecording.PODS];
    private final int[] shieldTimer = new int[GameRecording.PODS];
    private final boolean[] boostLeft = new boolean[GameRecording.PODS];
    private PodRace race;

    ObservedGame(GameRecording recording) {
        this.recording = recording;
        Arrays.fill(boostLeft, true);
        Arrays.fill(next, 1 % recording.checkpoints().length);
    }

    @Override
    public int turns() {
        return recording.turns().size();
    }

    @Override
    public boolean isSilent(int turn) {
        return recording.turns().get(turn - 1).isSilent();
    }

    @Override
    public boolean isOver() {
        return !recording.ranks().isEmpty();
    }

    @Override
    public void start(Game played) {
        race = (PodRace) played;
    }

    @Override
    public boolean hasStart() {
        return !recording.start().pods().isEmpty();
    }

    @Override
    public void writeStart(JsonGenerator out) {
        for (int pod = 0; pod < GameRecording.PODS; pod++) {
            next[pod] = recording.start().pods().get(pod).nextCheckpoint();
        }
        writePods(out, recording.start().pods());
        writeTurnsLeft(out, recording.start());               // all have rank 1 there, at any distance
        ShownFrame.write(out, List.of(recording.first()));
    }

    @Override
    public void writeOutcome(JsonGenerator out, int number) {
        GameRecording.Turn turn = recording.turns().get(number - 1);
        if (turn.impacts() != null) {
            writeImpacts(out, turn.impacts());
        }
        List<GameRecording.Pod> after = turn.after().pods();
        for (int pod = 0; pod < GameRecording.PODS; pod++) {
            String[] command = turn.command(pod);
            String word = command.length < 3 ? "" : command[2];
            boolean shield = after.isEmpty() ? word.equalsIgnoreCase("SHIELD")
                : after.get(pod).shield() && (command.length > 0 || shieldTimer[pod] == 0);
            shieldTimer[pod] = shield ? PodRaceSettings.SHIELD_TURNS : Math.max(0, shieldTimer[pod] - 1);
            boostLeft[pod] &= !word.equalsIgnoreCase("BOOST");
        }
        if (!after.isEmpty()) {
            count(after);
            out.writeObjectPropertyStart("state");
            writePods(out, after);
            if (!race.isOver()) {
                writeTurnsLeft(out, turn.after());
            }
            out.writeEndObject();
        }
        if (!race.isOver()) {
            writeRanks(out, turn.after());
        }
        boolean last = number == turns();
        ShownFrame.write(out, turn.frames(), last ? recording.facts().scores() : new double[0]);
    }

    private static void writeTurnsLeft(JsonGenerator out, GameRecording.State state) {
        if (!state.counters().isEmpty()) {
            JsonObject.writeEach(out, "turnsLeft", state.counters(), counter -> out.writeNumber(counter.turnsLeft()));
        }
    }

    private static void writeRanks(JsonGenerator out, GameRecording.State state) {
        if (!state.counters().isEmpty()) {
            JsonObject.writeEach(out, "ranks", state.counters(), counter -> out.writeNumber(counter.rank()));
        }
    }

    private static void writeImpacts(JsonGenerator out, List<GameRecording.Impact> impacts) {
        JsonObject.writeAll(out, "impacts", impacts, impact -> {
            JsonNumbers.write(out, "time", impact.time());
            out.writeNumberProperty("a", impact.a());
            out.writeNumberProperty("b", impact.b());
            out.writeNumberProperty("ax", impact.ax());
            out.writeNumberProperty("ay", impact.ay());
            out.writeNumberProperty("bx", impact.bx());
            out.writeNumberProperty("by", impact.by());
            JsonNumbers.write(out, "impulse", impact.impulse());
            out.writeNumberProperty("meanVx", impact.meanVx());
            out.writeNumberProperty("meanVy", impact.meanVy());
        });
    }

    /**
     * A pod has passed as many checkpoints as its next one has moved on. Only at the last one of a race this does not
     * tell: the server leaves its number as the next, which fits both counts, so the computed count is taken.
     */
    private void count(List<GameRecording.Pod> pods) {
        int count = recording.checkpoints().length;
        int toFinish = race.settings().laps() * count;
        for (int pod = 0; pod < pods.size(); pod++) {
            int now = pods.get(pod).nextCheckpoint();
            passed[pod] += Math.floorMod(now - next[pod], count);
            next[pod] = now;
            if (now == 0 && passed[pod] >= toFinish - 1 && race.passed(pod) >= toFinish) {
                passed[pod] = race.passed(pod);
            }
        }
    }

    private void writePods(JsonGenerator out, List<GameRecording.Pod> pods) {
        JsonObject.writeEach(out, "bodies", pods.size(), k -> {
            GameRecording.Pod pod = pods.get(k);
            out.writeStartObject();
            out.writeNumberProperty("id", k);
            out.writeNumberProperty("player", k / GameRecording.PODS_PER_PLAYER);
            JsonNumbers.write(out, "x", pod.x());
            JsonNumbers.write(out, "y", pod.y());
            JsonNumbers.write(out, "vx", pod.vx());
            JsonNumbers.write(out, "vy", pod.vy());
            JsonNumbers.writeOrNull(out, "heading", pod.heading());
            out.writeNumberProperty("shieldTimer", shieldTimer[k]);
            out.writeBooleanProperty("boostLeft", boostLeft[k]);
            out.writeNumberProperty("passed", passed[k]);
            out.writeEndObject();
        });
    }

    @Override
    public int rank(int player) {
        return recording.ranks().isEmpty() ? -1 : recording.ranks().get(player);
    }
}
