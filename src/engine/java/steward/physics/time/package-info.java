/** Times of impact of circles with circles and walls, in every arithmetic: solutions of the same quadratic. */
package steward.physics.time;
