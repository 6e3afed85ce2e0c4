/**
 * Neighbours by cells: only bodies of cells next to each other are looked at, and each body has one event in a queue,
 * its predicted impact or its cell crossing; for many bodies.
 */
package steward.physics.event.cells;
