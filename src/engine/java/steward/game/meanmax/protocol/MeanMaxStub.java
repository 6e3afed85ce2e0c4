package steward.game.meanmax.protocol;

import java.util.List;
import steward.game.BotStub;
import steward.game.BotStub.Command;
import steward.game.BotStub.Input;

/** Input and answers of starter bots for Mean Max: each looter goes for the nearest thing that it is made for. */
final class MeanMaxStub {

    private static final List<String> NOTES = List.of(
        "The reaper takes water from wrecks while it is in one, the destroyer sinks tankers by touching them,",
        "the doof gets in the way of others and collects rage, which skills cost.",
        "A looter slides: a better reaper stops in its wreck. Power divided by mass is what a speed gains.");

    static final BotStub LINES = new BotStub(List.of(),
        List.of(Input.values("myScore:int score1:int score2:int"), Input.values("myRage:int rage1:int rage2:int"),
            Input.values("unitCount:int"), Input.lines("units", "Unit", "unitCount", "id:int type:int player:int "
                + "mass:real radius:int x:int y:int vx:int vy:int extra:int extra2:int")), "",
        List.of(
            Command.each("reaper", "units", "reaper.type == 0 && reaper.player == 0")
                .nearest("wreck", "units", "each.type == 4", "reaper")
                .when("wreck", "wreck.x - reaper.vx, wreck.y - reaper.vy, 300").otherwise("0, 0, 300"),
            Command.each("destroyer", "units", "destroyer.type == 1 && destroyer.player == 0")
                .nearest("tanker", "units", "each.type == 3", "destroyer")
                .when("tanker", "tanker.x, tanker.y, 300").otherwise("'WAIT'"),
            Command.each("doof", "units", "doof.type == 2 && doof.player == 0")
                .nearest("rival", "units", "each.type == 0 && each.player != 0", "doof")
                .when("rival", "rival.x, rival.y, 300").otherwise("'WAIT'")),
        BotStub.notes(NOTES,
            "Types: 0 reaper, 1 destroyer, 2 doof, 3 tanker, 4 wreck, 5 tar, 6 oil, 7 grenade; player 0 is you.",
            "A command can also be SKILL X Y, within 2000 u."));

    static final BotStub FRAMES = new BotStub(List.of(Input.values("player:int maximumPower:int")),
        List.of(Input.objects("units", "Unit", "id:int kind:word player:int mass:real radius:real x:real y:real "
                + "vx:real vy:real water:int size:int"),
            Input.objects("wrecks", "Wreck", "id:int radius:real x:real y:real water:int"),
            Input.objects("effects", "Effect", "id:int skill:word x:real y:real duration:int")), "looters",
        List.of(
            Command.each("reaper", "units", "reaper.kind == 'reaper' && reaper.player == player")
                .nearest("wreck", "wrecks", "", "reaper")
                .when("wreck", "x: wreck.x - reaper.vx, y: wreck.y - reaper.vy, power: maximumPower")
                .otherwise("x: 0, y: 0, power: maximumPower"),
            Command.each("destroyer", "units", "destroyer.kind == 'destroyer' && destroyer.player == player")
                .nearest("tanker", "units", "each.kind == 'tanker'", "destroyer")
                .when("tanker", "x: tanker.x, y: tanker.y, power: maximumPower").otherwise("wait: true"),
            Command.each("doof", "units", "doof.kind == 'doof' && doof.player == player")
                .nearest("rival", "units", "each.kind == 'reaper' && each.player != player", "doof")
                .when("rival", "x: rival.x, y: rival.y, power: maximumPower").otherwise("wait: true")),
        BotStub.notes(NOTES, "A command can also have skill: true in place of the power, within 2000 u."));

    private MeanMaxStub() { }
}
