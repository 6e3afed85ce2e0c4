package steward.minigame;

import java.util.List;
import steward.game.Game;
import steward.game.GameJson;
import steward.game.GameSetup;
import steward.game.GameType;
import steward.game.Pilot;
import steward.physics.Contacts;
import steward.physics.Contacts.Meaning;
import steward.physics.PhysicsParts;
import steward.physics.Reaction;
import steward.scene.Part;
import steward.scene.Plan;
import steward.scene.Scene;

/** The pond as a game that scenes can name. */
final class PondType implements GameType {

    @Override
    public String id() {
        return "pond";
    }

    @Override
    public int fewestPlayers() {
        return 2;
    }

    @Override
    public GameSetup open(Scene scene) {
        PondSettings settings = PondSettings.read(scene);
        scene.root().done();
        Contacts contacts = new Contacts(Pond.KINDS)
            .set(Pond.HUNTER, Pond.HUNTER, Meaning.ASK).set(Pond.HUNTER, Pond.BUBBLE, Meaning.ASK)
            .set(Pond.HUNTER, Pond.CELL, Meaning.ASK).set(Pond.HUNTER, Pond.FOG, Meaning.ASK)
            .set(Pond.FOG, Pond.FOG, Meaning.NONE).set(Pond.FOG, Pond.BUBBLE, Meaning.NONE)
            .set(Pond.FOG, Pond.CELL, Meaning.NONE).set(Pond.BUBBLE, Pond.BUBBLE, Meaning.NONE);
        Plan plan = Plan.of(scene, contacts, 1, false,
            List.of(new Part("growth", true, "hunters eat cells and each other")));
        return new Setup(scene, settings, plan);
    }

    /** A pond with the settings of one scene. */
    record Setup(Scene scene, PondSettings settings, Plan plan) implements GameSetup {

        @Override
        public Pond create(long seed) {
            return new Pond(settings, scene, plan, seed);
        }

        @Override
        public GameJson codec(Game game) {
            return new PondJson((Pond) game);
        }

        @Override
        public PhysicsParts physics() {
            return plan.physics((time, a, b, bodies, sink) -> Reaction.Verdict.BOUNCE);
        }

        @Override
        public Pilot pilot(Pilot.Aim aim) {
            return (game, player, random) -> "{\"push\":{\"x\":" + random.nextInt(-5, 5) + ",\"y\":"
                + random.nextInt(-5, 5) + "}}";
        }
    }
}
