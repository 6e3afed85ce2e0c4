/**
 * Times of impact of circles with circles and walls, in every arithmetic. They are one family of solutions of the same
 * quadratic, from the published referee's own expressions to exact signs with double-double results.
 */
package steward.physics.time;
