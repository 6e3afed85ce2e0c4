package steward.game.searchrace.protocol;

import java.util.List;
import steward.game.BotStub;
import steward.game.BotStub.Command;
import steward.game.BotStub.Input;

/** Input and answers of starter bots for the search race: the car aims against its drift. */
final class SearchRaceStub {

    private static final String PLACE = "x:int y:int";
    private static final String OFF = "degreesOff(car.x, car.y, car.heading, targetX, targetY) > 75";
    private static final String DRIFT =
        "The car keeps most of its speed from turn to turn: aim beside the checkpoint, against that drift.";
    private static final String TURN =
        "It can turn by only 18 degrees a turn, so give no thrust while it looks elsewhere.";

    static final BotStub LINES = new BotStub(
        List.of(Input.values("checkpointCount:int"),
            Input.lines("checkpoints", "Checkpoint", "checkpointCount", PLACE)),
        List.of(Input.record("car", "Car", "passed:int x:int y:int vx:int vy:int heading:int")), "",
        List.of(steer("passed").when(OFF, "targetX, targetY, 0").otherwise("targetX, targetY, 200")),
        List.of(DRIFT, TURN, "In place of X Y THRUST you can say EXPERT ANGLE THRUST, to turn by -18..18 degrees."));

    static final BotStub FRAMES = new BotStub(
        List.of(Input.values("laps:int maximumThrust:int"), Input.objects("checkpoints", "Checkpoint", PLACE)),
        List.of(Input.record("car", "Car",
            "x:int y:int vx:int vy:int heading:int passed:int next=nextCheckpoint:int")), "",
        List.of(steer("next").when(OFF, "x: targetX, y: targetY, thrust: 0")
            .otherwise("x: targetX, y: targetY, thrust: maximumThrust")),
        List.of(DRIFT, TURN, "In place of x and y a command can have turn: by how many degrees, -18..18."));

    private SearchRaceStub() { }

    private static Command steer(String next) {
        return Command.single().let("targetX", "checkpoints[car." + next + "].x - 4 * car.vx")
            .let("targetY", "checkpoints[car." + next + "].y - 4 * car.vy");
    }
}
