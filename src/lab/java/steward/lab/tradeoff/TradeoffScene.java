package steward.lab.tradeoff;

import java.util.function.Supplier;
import steward.physics.Bodies;
import steward.physics.Motion;
import steward.physics.PhysicsParts;

/**
 * Scene of the trade-off measurement, with its starting states.
 *
 * @param name      a word, unique among those of a run
 * @param about     a readable description
 * @param inChild   what a JVM that times a rung of it is told: the scene as JSON, or the name of a world
 * @param parts     law, contacts (which all bounce), walls; each rung uses its own arithmetic
 * @param motion    the rounding at the end of a turn, if it rounds both positions and velocities; otherwise
 *                  {@code null}
 * @param source    supplies starting states, always the same in the same order; used once
 * @param states    how many of them a normal run takes
 * @param freeRuns  how many free runs
 * @param freeTurns how many turns these have at most
 * @param mostSteps rungs with more steps per turn are left out
 */
public record TradeoffScene(String name, String about, String inChild, PhysicsParts parts, Motion motion,
                            Supplier<Bodies> source, int states, int freeRuns, int freeTurns, int mostSteps) { }
