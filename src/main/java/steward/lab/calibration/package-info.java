/**
 * One scene, measured: which accuracy each rung reaches on seeded states of it, and what each part of its engine costs
 * a turn.
 */
@Internal
package steward.lab.calibration;

import steward.Internal;
