/** Measurements of one scene: accuracy of each rung on seeded states, and cost of each part of its engine. */
package steward.lab.calibration;
