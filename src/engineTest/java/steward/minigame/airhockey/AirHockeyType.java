package steward.minigame.airhockey;

import java.util.List;
import steward.game.Game;
import steward.game.GameJson;
import steward.game.GameSetup;
import steward.game.GameType;
import steward.game.Pilot;
import steward.physics.Contacts;
import steward.physics.PhysicsParts;
import steward.scene.Part;
import steward.scene.Plan;
import steward.scene.Scene;

/** Air hockey as a game that scenes can name. */
final class AirHockeyType implements GameType {

    @Override
    public String id() {
        return "air-hockey";
    }

    @Override
    public int fewestPlayers() {
        return 2;
    }

    @Override
    public int mostPlayers() {
        return 2;
    }

    @Override
    public GameSetup open(Scene scene) {
        HockeySettings settings = HockeySettings.read(scene);
        scene.root().done();
        Contacts contacts = new Contacts(2).setWall(AirHockey.PUCK, Contacts.Meaning.ASK);
        return new Setup(scene, settings, Plan.of(scene, contacts, 1, false, AirHockey.RADIUS.length,
            List.of(new Part("goals", true, "the puck scores in the middle of two walls", Part.When.OUTCOME))));
    }

    /** Air hockey with the settings of one scene. */
    record Setup(Scene scene, HockeySettings settings, Plan plan) implements GameSetup {

        @Override
        public AirHockey create(long seed) {
            return new AirHockey(settings, scene.drag(), plan, seed);
        }

        @Override
        public GameJson codec(Game game) {
            return new HockeyJson((AirHockey) game, settings);
        }

        @Override
        public PhysicsParts physics() {
            return plan.physics(new AirHockey.Touch(settings));
        }

        /** Pushes at random, whatever the aim. */
        @Override
        public Pilot pilot(Pilot.Aim aim) {
            return (game, player, random) -> "{\"x\":" + random.nextInt(-20, 20) + ",\"y\":" + random.nextInt(-20, 20)
                + "}";
        }
    }
}
