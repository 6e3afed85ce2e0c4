/**
 * The truth in many digits: a turn computed with 64 decimal digits. It reads the plain data of a scene (bodies, walls,
 * law) and shares no code with the physics it checks. A heap that comes to rest is no matter of impacts: there the rung
 * {@code exact} stands for the truth.
 */
package steward.lab.oracle;
