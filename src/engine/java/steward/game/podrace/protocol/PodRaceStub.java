package steward.game.podrace.protocol;

import java.util.List;
import steward.game.BotStub;
import steward.game.BotStub.Command;
import steward.game.BotStub.Input;

/** Input and answers of starter bots for the pod race: they aim against their drift. Lines are for two pods each. */
final class PodRaceStub {

    private static final String PLACE = "x:int y:int";
    private static final String POD = "x:int y:int vx:int vy:int heading:int next:int";

    private static final List<String> NOTES = List.of(
        "A pod keeps most of its speed from turn to turn: aim beside the checkpoint, against 4 turns of that.",
        "A pod can turn by only 18 degrees a turn, so give no thrust while it looks elsewhere.",
        "Its heading is in degrees, and -1 before the first command: then any direction is possible.");

    static final BotStub LINES = new BotStub(
        List.of(Input.values("laps:int"), Input.values("checkpointCount:int"),
            Input.lines("checkpoints", "Checkpoint", "checkpointCount", PLACE)),
        List.of(Input.lines("pods", "Pod", "2", POD), Input.lines("rivals", "Pod", "2", POD)), "",
        List.of(steer(Command.each("pod", "pods", ""))
            .when("pod.heading >= 0 && degreesOff(pod.x, pod.y, pod.heading, targetX, targetY) > 80",
                "targetX, targetY, 0")
            .otherwise("targetX, targetY, 200")),
        BotStub.notes(NOTES, "In place of the thrust you can say SHIELD or BOOST (the boost works once).",
            "These are the lines for two pods each. The lower leagues have one, and other lines."));

    static final BotStub FRAMES = new BotStub(
        List.of(Input.values("player:int laps:int maximumThrust:int"),
            Input.objects("checkpoints", "Checkpoint", PLACE)),
        List.of(Input.values("turnsLeft:int"), Input.objects("pods", "Pod",
            "player:int x:real y:real vx:real vy:real heading:real next=nextCheckpoint:int")), "pods",
        List.of(steer(Command.each("pod", "pods", "pod.player == player"))
            .when("pod.heading >= 0 && degreesOff(pod.x, pod.y, pod.heading, targetX, targetY) > 80",
                "x: targetX, y: targetY, thrust: 0")
            .otherwise("x: targetX, y: targetY, thrust: maximumThrust")),
        BotStub.notes(NOTES,
            "In place of the thrust a command can have shield: true or boost: true (the boost works once)."));

    private PodRaceStub() { }

    private static Command steer(Command pod) {
        return pod.let("targetX", "checkpoints[pod.next].x - 4 * pod.vx")
            .let("targetY", "checkpoints[pod.next].y - 4 * pod.vy");
    }
}
