package steward.game.pokerchiprace.protocol;

import java.util.List;
import steward.game.BotStub;
import steward.game.BotStub.Command;
import steward.game.BotStub.Input;

/** Input and answers of starter bots for the Poker Chip Race: a slow chip pushes itself to the nearest smaller one. */
final class PokerChipRaceStub {

    private static final String SLOW = " && chip.vx * chip.vx + chip.vy * chip.vy < 200";
    private static final List<String> NOTES = List.of(
        "A bigger chip eats a smaller one. Every push costs a fifteenth of the chip's area, so it drifts once it",
        "is on its way. Aim ahead of what moves. A chip with a radius of 5 or less cannot push itself.");

    static final BotStub LINES = new BotStub(List.of(Input.values("player:int")),
        List.of(Input.values("ownCount:int"), Input.values("chipCount:int"), Input.lines("chips", "Chip", "chipCount",
            "id:int player:int radius:real x:real y:real vx:real vy:real")), "",
        List.of(Command.each("chip", "chips", "chip.player == player")
            .nearest("prey", "chips", "each.player != player && each.radius < chip.radius", "chip")
            .when("prey" + SLOW, "prey.x, prey.y").otherwise("'WAIT'")), NOTES);

    static final BotStub FRAMES = new BotStub(List.of(Input.values("player:int smallRadius:real")),
        List.of(Input.objects("chips", "Chip", "id:int player:int radius:real x:real y:real vx:real vy:real")), "chips",
        List.of(Command.each("chip", "chips", "chip.player == player")
            .nearest("prey", "chips", "each.player != player && each.radius < chip.radius", "chip")
            .when("prey" + SLOW, "x: prey.x, y: prey.y").otherwise("wait: true")), NOTES);

    private PokerChipRaceStub() { }
}
