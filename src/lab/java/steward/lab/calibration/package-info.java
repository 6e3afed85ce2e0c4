/** Calibration of one scene: the accuracy of each rung on seeded states of it, and its cost. */
package steward.lab.calibration;
