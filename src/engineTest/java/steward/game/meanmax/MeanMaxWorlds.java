package steward.game.meanmax;

import steward.numerics.JavaRandom;

/** Worlds of Mean Max that tests of its rules fill unit by unit. */
final class MeanMaxWorlds {

    private MeanMaxWorlds() { }

    /** A world without units that goes on with the tankers of a seed. */
    static MeanMaxWorld empty(MeanMaxSettings settings, long seed, int capacity) {
        JavaRandom random = new JavaRandom(seed);
        random.nextInt(3);
        return new MeanMaxWorld(settings, MeanMaxSettings.PLAYERS, capacity,
            new TankerQueue(random, MeanMaxSettings.PLAYERS));
    }

    /** Takes ids until the next one is this. */
    static void takeIdsUpTo(MeanMaxWorld world, int next) {
        while (world.bodies().nextId() < next) {
            world.bodies().takeId();
        }
    }

    /** Adds a unit with an id of at least the next one. @return its index */
    static int addUnit(MeanMaxWorld world, int id, UnitKind kind, int player, double radius, double mass, int water,
                       int size) {
        takeIdsUpTo(world, id);
        int body = world.add(kind, player, 0, 0, radius, mass);
        world.bodies().columns[MeanMaxWorld.WATER][body] = water;
        world.bodies().columns[MeanMaxWorld.SIZE][body] = size;
        return body;
    }

    /** A game in another world, with other scores and rages. */
    static MeanMax game(MeanMax of, MeanMaxWorld world, int[] scores, int... rages) {
        MeanMax game = new MeanMax(of, world);
        System.arraycopy(scores, 0, game.scores, 0, scores.length);
        System.arraycopy(rages, 0, game.rages, 0, rages.length);
        return game;
    }
}
