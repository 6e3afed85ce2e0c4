package steward.game.fantasticbits.protocol;

import java.util.List;
import steward.game.BotStub;
import steward.game.BotStub.Command;
import steward.game.BotStub.Input;

/** Input and answers of starter bots for Fantastic Bits: wizards take the nearest snaffle and throw it at the goal. */
final class FantasticBitsStub {

    private static final List<String> NOTES = List.of(
        "A wizard that holds a snaffle throws it, or lets it go. Both go for the nearest one: share them better.",
        "Spells cost magic: obliviate a bludger (it forgets you), petrificus (the target stops),",
        "accio (it comes to you), flipendo (it is pushed away from you).");

    static final BotStub LINES = new BotStub(List.of(Input.values("player:int")),
        List.of(Input.values("myScore:int myMagic:int"), Input.values("score:int magic:int"),
            Input.values("entityCount:int"), Input.lines("entities", "Entity", "entityCount",
                "id:int type:word x:int y:int vx:int vy:int state:int")), "",
        List.of(Command.each("wizard", "entities", "wizard.type == 'WIZARD'")
            .nearest("snaffle", "entities", "each.type == 'SNAFFLE'", "wizard")
            .when("wizard.state == 1", "'THROW', 16000 - 16000 * player, 3750, 500")
            .when("snaffle", "'MOVE', snaffle.x + snaffle.vx, snaffle.y + snaffle.vy, 150")
            .otherwise("'MOVE', 8000, 3750, 150")),
        List.of(NOTES.get(0), NOTES.get(1), NOTES.get(2),
            "Types: WIZARD (yours), OPPONENT_WIZARD, SNAFFLE, BLUDGER. A spell is its name and an id: ACCIO 5",
            "The contest of 2016 has no lines of scores and magic."));

    static final BotStub FRAMES = new BotStub(
        List.of(Input.values("player:int maximumPower:int maximumThrow:int"),
            Input.record("goal", "Goal", "x:real top:real bottom:real")),
        List.of(Input.objects("entities", "Entity",
            "id:int kind:word player:int x:real y:real vx:real vy:real snaffle:int")), "wizards",
        List.of(Command.each("wizard", "entities", "wizard.kind == 'wizard' && wizard.player == player")
            .nearest("prey", "entities", "each.kind == 'snaffle'", "wizard")
            .when("wizard.snaffle >= 0", "x: goal.x, y: (goal.top + goal.bottom) / 2, throw: maximumThrow")
            .when("prey", "x: prey.x + prey.vx, y: prey.y + prey.vy, power: maximumPower")
            .otherwise("x: 8000, y: 3750, power: maximumPower")),
        List.of(NOTES.get(0), NOTES.get(1), NOTES.get(2), "A spell is a command with spell: 'accio' and target: an id. "
            + "The frame has scores and magic by player."));

    private FantasticBitsStub() { }
}
