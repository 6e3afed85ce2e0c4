package steward.lab.stability;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import steward.game.Game;
import steward.game.GameJson;
import steward.game.GameSetup;
import steward.game.Pilot;
import steward.lab.trial.Gas;
import steward.lab.trial.PairSampler;
import steward.lab.trial.RunLength;
import steward.lab.trial.Rung;
import steward.numerics.SplitMix64;
import steward.numerics.StateHash;
import steward.physics.Advance;
import steward.physics.Arena;
import steward.physics.Bodies;
import steward.physics.ImpactLaw;
import steward.physics.Segment;
import steward.physics.TurnLog;
import steward.physics.Wall;

/**
 * One number for all computed results: the hash of every bit of worlds and games on every rung. It must be the same on
 * every machine, JDK, compiler level and garbage collector; if it differs, the hashes of the parts show the place.
 */
public final class GoldenHash {

    private static final long SEED = 4;
    private static final ImpactLaw SOFT = ImpactLaw.PHYSICS.withRestitution(ImpactLaw.Restitution.MINIMUM);

    private GoldenHash() { }

    /**
     * A named hash.
     *
     * @param name unique in the suite
     * @param hash of all bits of the part
     */
    public record Part(String name, long hash) { }

    public static long total(List<Part> parts) {
        StateHash hash = new StateHash();
        parts.forEach(part -> hash.add(part.hash));
        return hash.value();
    }

    /** Worlds without a game on every rung: a gas among all kinds of walls, a crowd, heaps of pods, pairs. */
    public static List<Part> worlds(RunLength size) {
        List<Part> parts = new ArrayList<>();
        for (Rung rung : Rung.all()) {
            int turns = size.pick(3, 40, 400);
            Wall[] walls = {new Arena(0, 0, 900, 0.9), new Segment(-300, -100, 250, 120, 1)};
            parts.add(new Part("gas, " + rung.name(), gas(rung.advance(SOFT, walls), turns)));
            parts.add(new Part("crowd, " + rung.name(), crowd(rung, size.pick(1, 20, 200))));
            parts.add(new Part("heaps, " + rung.name(),
                heaps(rung.advance(ImpactLaw.OFFICIAL_POD_RACE), size.pick(100, 3000, 30_000))));
            parts.add(new Part("pairs, " + rung.name(),
                pairs(rung.advance(ImpactLaw.PHYSICS), size.pick(200, 20_000, 200_000))));
        }
        return parts;
    }

    private static long gas(Advance advance, int turns) {
        SplitMix64 random = new SplitMix64(SEED);
        Bodies bodies = new Bodies(25);
        for (int k = 0; k < 25; k++) {
            bodies.add(200 * (k % 5 - 2) + 60 * random.nextDouble(), 200 * (k / 5 - 2) + 60 * random.nextDouble(), 40,
                1 + 3 * random.nextDouble());
            bodies.setVelocity(k, 900 * (random.nextDouble() - 0.5), 900 * (random.nextDouble() - 0.5));
            bodies.setRestitution(k, 0.5 + 0.5 * random.nextDouble());
        }
        StateHash hash = new StateHash();
        for (int turn = 0; turn < turns; turn++) {
            play(advance, bodies, hash);
        }
        return hash.value();
    }

    private static long crowd(Rung rung, int turns) {
        Gas gas = new Gas(SEED, 200, 0.3);
        Advance advance = rung.crowdAdvance(ImpactLaw.PHYSICS, gas.walls());
        Bodies bodies = gas.bodies();
        StateHash hash = new StateHash();
        for (int turn = 0; turn < turns; turn++) {
            play(advance, bodies, hash);
        }
        return hash.value();
    }

    private static long heaps(Advance advance, int states) {
        SplitMix64 random = new SplitMix64(SEED);
        StateHash hash = new StateHash();
        for (int n = 0; n < states; n++) {
            Bodies bodies = new Bodies(4);
            for (int k = 0; k < 4; k++) {
                double mass = random.nextInt(4) == 0 ? 10 : 1;
                bodies.add(1500 * random.nextDouble(), 1500 * random.nextDouble(), 400, mass);
                bodies.setVelocity(k, 2000 * (random.nextDouble() - 0.5), 2000 * (random.nextDouble() - 0.5));
            }
            play(advance, bodies, hash);
        }
        return hash.value();
    }

    private static long pairs(Advance advance, int pairs) {
        SplitMix64 random = new SplitMix64(SEED);
        StateHash hash = new StateHash();
        for (int n = 0; n < pairs; n++) {
            double off = StrictMath.pow(10, -random.nextInt(1, 16));
            play(advance, PairSampler.passing(random, PairSampler.around(random, random.nextInt(-50, 50)),
                n % 2 == 0 ? 1 - off : off, random.nextDouble(), 0.5, 0, 0), hash);
        }
        return hash.value();
    }

    private static void play(Advance advance, Bodies bodies, StateHash hash) {
        TurnLog log = new TurnLog();
        advance.turn(bodies, log);
        for (int k = 0; k < log.impacts(); k++) {
            hash.add(log.impact(k).time()).add(log.impact(k).impulse());
        }
        for (int k = 0; k < bodies.size(); k++) {
            hash.add(bodies.x[k]).add(bodies.y[k]).add(bodies.vx[k]).add(bodies.vy[k]);
        }
    }

    /**
     * A game whose players answer by rule: a part with the hashes of all its turns. Each has a generator of its own,
     * the same in every play of the game.
     *
     * @param turns at most this many turns
     * @throws IllegalArgumentException if an answer is refused
     */
    public static Part game(String name, GameSetup setup, Pilot pilot, int turns) {
        Game game = setup.create(SEED);
        GameJson codec = setup.codec(game);
        SplitMix64[] randoms = new SplitMix64[game.players()];
        Arrays.setAll(randoms, player -> new SplitMix64(SEED + player));
        StateHash hash = new StateHash();
        while (!game.isOver() && game.turn() < turns) {
            for (int player = 0; player < randoms.length; player++) {
                byte[] answer = pilot.answer(game, player, randoms[player]).getBytes(StandardCharsets.UTF_8);
                String problem = game.isIn(player) ? codec.readAnswer(player, answer, answer.length) : null;
                if (problem != null) {
                    throw new IllegalArgumentException(name + ", player " + player + ": " + problem);
                }
            }
            game.play();
            hash.add(game.hash());
        }
        return new Part(name, hash.value());
    }
}
