/**
 * The way to advance many bodies: cells to find neighbours, an event queue of predicted impacts and cell crossings,
 * and a local clock for each body in free flight. The same law and the same impacts as by all pairs.
 */
package steward.physics.queue;
