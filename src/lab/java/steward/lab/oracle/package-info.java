/**
 * The truth in many digits: a turn computed with 64 decimal digits. It reads the plain data of a scene (bodies, walls,
 * law) and shares no code with the physics it checks.
 */
package steward.lab.oracle;
