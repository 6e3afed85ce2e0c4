package steward.lab.tradeoff;

import java.util.function.Supplier;
import steward.physics.Bodies;
import steward.physics.Motion;
import steward.physics.PhysicsParts;

/**
 * What the trade-off is measured on.
 *
 * @param name      a word, unique among those of a run
 * @param about     what it is, for people
 * @param parts     law, contacts (which all bounce), walls; each rung puts in its own arithmetic
 * @param motion    what the end of a turn does to numbers, if it rounds both positions and velocities; otherwise
 *                  {@code null}
 * @param source    gives starting states, always the same ones in the same order; used once
 * @param states    how many of them an ordinary run takes
 * @param freeRuns  how many free runs
 * @param freeTurns how many turns these have at most
 * @param mostSteps rungs with more steps a turn are left out
 */
public record TradeoffScene(String name, String about, PhysicsParts parts, Motion motion, Supplier<Bodies> source,
                            int states, int freeRuns, int freeTurns, int mostSteps) {
}
