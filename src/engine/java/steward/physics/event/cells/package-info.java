/**
 * Neighbours by cells, for many bodies: only bodies of adjacent cells are looked at. Each body has one event in a
 * queue, its predicted impact or its cell crossing.
 *
 * <p>Predictions take most of the time of a dense crowd, and few of them become stale. Cells cannot be narrower than a
 * diameter. Among 100,000 discs lines of memory that are in no cache decide. Tried there, and not faster: wider
 * buckets, whose ring is smaller but whose heaps are longer; the second body of each cell beside the first; links of
 * cells in the records of their bodies; index, id and mass in one record; bounds of the distance to walls. A filter
 * that also uses the next impact of the other body is faster at 75%, but slower at 10%.
 */
package steward.physics.event.cells;
