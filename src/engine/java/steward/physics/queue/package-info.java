/** The way to advance many bodies: cells, a queue of predicted events and a clock for each body in free flight. */
package steward.physics.queue;
