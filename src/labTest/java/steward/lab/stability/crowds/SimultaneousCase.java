package steward.lab.stability.crowds;

import java.util.Locale;
import java.util.stream.IntStream;
import steward.lab.trial.Finding;
import steward.lab.trial.RunLength;
import steward.lab.trial.Rung;
import steward.lab.trial.StabilityCase;
import steward.numerics.SplitMix64;
import steward.physics.Advance;
import steward.physics.Bodies;
import steward.physics.ImpactLaw;
import steward.physics.TurnLog;
import steward.physics.Wall;

/**
 * Stability case of {@link TiedWorlds}: simultaneous impacts whose time is no double must react in the order of ids.
 */
public final class SimultaneousCase extends StabilityCase {

    private static final long SEED = 32;

    public SimultaneousCase() {
        super("simultaneous impacts",
            "several pairs and walls meet at one time, rational or irrational, in two dimensions. On exact every one"
            + " reacts in the order of ids, one by one and as a crowd; counted on the others");
    }

    @Override
    public Finding run(Rung rung, RunLength size) {
        int worlds = size.pick(200, 1_000, 20_000);
        SplitMix64 random = new SplitMix64(SEED);
        int alone = 0;
        int crowd = 0;
        for (int n = 0; n < worlds; n++) {
            TiedWorlds.World world = TiedWorlds.draw(random);
            Wall[] walls = world.walls().toArray(new Wall[0]);
            alone += isByTheRule(rung.advance(ImpactLaw.PHYSICS, walls), world) ? 1 : 0;
            crowd += isByTheRule(rung.crowdAdvance(ImpactLaw.PHYSICS, walls), world) ? 1 : 0;
        }
        return Finding.of(rung.isExact(), alone == worlds && crowd == worlds, String.format(Locale.ROOT,
            "%d worlds: %d in the order of the rule one by one, %d as a crowd", worlds, alone, crowd));
    }

    /** True if the first impacts of a turn are those that the rule says. */
    static boolean isByTheRule(Advance advance, TiedWorlds.World world) {
        Bodies bodies = world.bodies().copy();
        TurnLog log = new TurnLog();
        advance.turn(bodies, log);
        return world.impacts().equals(IntStream.range(0, Math.min(log.impacts(), world.impacts().size()))
            .mapToObj(k -> log.impact(k).a() + " " + log.impact(k).b()).toList());
    }
}
