package steward.game.bodies.protocol;

import java.util.List;
import steward.game.BotStub;
import steward.game.BotStub.Command;
import steward.game.BotStub.Input;

/**
 * Input and answers of starter bots for the game {@code bodies}: each disc goes for the nearest zone or foreign disc.
 */
final class BodiesStub {

    private static final String ZONE = "x:real y:real radius:real points:real";
    private static final String BODY = "x:real y:real vx:real vy:real";
    private static final List<String> NOTES = List.of(
        "A command is a thrust: it changes the disc's speed by itself over the disc's mass.",
        "The scene says what gives points: zones, or contacts with bodies that are not yours.");

    static final BotStub LINES = new BotStub(
        List.of(Input.values("player:int playerCount:int discCount:int zoneCount:int"),
            Input.lines("discs", "Disc", "discCount", "player:int radius:real mass:real"),
            Input.lines("zones", "Zone", "zoneCount", ZONE)),
        List.of(Input.lines("scores", "Score", "playerCount", "points:real"),
            Input.lines("bodies", "Body", "discCount", BODY)), "",
        List.of(push("", ", ", "").otherwise("0, 0")),
        BotStub.notes(NOTES, "The lines do not say how long a thrust may be."));

    static final BotStub FRAMES = new BotStub(
        List.of(Input.values("player:int maximumThrust:real"),
            Input.objects("discs=bodies", "Disc", "id:int player:int radius:real"),
            Input.objects("zones", "Zone", ZONE)),
        List.of(Input.objects("bodies", "Body", BODY)), "thrusts",
        List.of(push("x: ", ", y: ", " * maximumThrust").otherwise("x: 0, y: 0")), NOTES);

    private BodiesStub() { }

    /** Pushes with a length below 1, times a factor. */
    private static Command push(String x, String y, String factor) {
        Command disc = Command.each("disc", "discs", "disc.player == player").let("body", "bodies[index]")
            .nearest("zone", "zones", "", "body")
            .nearest("other", "bodies", "distance(body.x, body.y, each.x, each.y) > 0", "body");
        for (String goal : List.of("zone", "other")) {
            String over = factor + " / (1 + distance(body.x, body.y, " + goal + ".x, " + goal + ".y))";
            disc = disc.when(goal, x + "(" + goal + ".x - body.x)" + over + y + "(" + goal + ".y - body.y)" + over);
        }
        return disc;
    }
}
