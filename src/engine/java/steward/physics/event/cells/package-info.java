/**
 * Neighbours by cells, for many bodies: only bodies of adjacent cells are looked at. Each body has one event in a
 * queue, its predicted impact or its cell crossing.
 */
package steward.physics.event.cells;
