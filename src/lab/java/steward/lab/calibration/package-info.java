/**
 * Measurements of one scene: the accuracy of each rung on seeded states of it, and the cost that each part of its
 * engine adds to a turn.
 */
package steward.lab.calibration;
