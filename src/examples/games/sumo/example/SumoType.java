package example;

import java.util.List;
import steward.game.BotStub;
import steward.game.BotStub.Command;
import steward.game.BotStub.Input;
import steward.game.Game;
import steward.game.GameJson;
import steward.game.GameSetup;
import steward.game.GameType;
import steward.game.Pilot;
import steward.physics.Contacts;
import steward.scene.Part;
import steward.scene.Plan;
import steward.scene.Scene;
import steward.scene.json.Block;

/** Sumo as a game that scenes can name. */
public final class SumoType implements GameType {

    @Override
    public String id() {
        return "sumo";
    }

    @Override
    public int fewestPlayers() {
        return 2;
    }

    @Override
    public int mostPlayers() {
        return 2;
    }

    /** Starters in all languages push toward the rival. Sumo has no lines of text. */
    @Override
    public BotStub frameStub() {
        return new BotStub(List.of(Input.values("player:int push:real")),
            List.of(Input.objects("bodies", "Body", "x:real y:real vx:real vy:real")), "",
            List.of(Command.single().let("me", "bodies[player]").let("rival", "bodies[1 - player]")
                .let("share", "push / (1 + distance(me.x, me.y, rival.x, rival.y))")
                .otherwise("x: (rival.x - me.x) * share, y: (rival.y - me.y) * share")),
            List.of("Push toward the rival; who leaves the ring around (0, 0) has lost."));
    }

    @Override
    public GameSetup open(Scene scene) {
        Block sumo = scene.root().block("sumo");
        Sumo.Settings settings = new Sumo.Settings(sumo.positive("ring"), sumo.positive("push"),
            sumo.integer("maximumTurns", 1, 10_000));
        scene.root().done();
        return new Setup(scene, settings, Plan.of(scene, new Contacts(1), 1, false,
            List.of(new Part("ring", true, "who leaves it has lost", Part.When.OUTCOME))));
    }

    /** Sumo with the settings of one scene. */
    record Setup(Scene scene, Sumo.Settings settings, Plan plan) implements GameSetup {

        @Override
        public Sumo create(long seed) {
            return new Sumo(settings, scene.drag(), plan, seed);
        }

        @Override
        public GameJson codec(Game game) {
            return new SumoJson((Sumo) game, settings);
        }

        /** Pushes at random, whatever the aim. */
        @Override
        public Pilot pilot(Pilot.Aim aim) {
            return (game, player, random) -> "{\"x\":" + random.nextInt(-5, 5) + ",\"y\":" + random.nextInt(-5, 5)
                + "}";
        }
    }
}
