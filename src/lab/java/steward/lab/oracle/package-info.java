/**
 * The oracle: a reference computation of a turn with 64 decimal digits. It reads the plain data of a scene (bodies,
 * walls, law) and shares no code with the physics it checks. One exception: a heap that comes to rest is compared with
 * the rung {@code exact}.
 */
package steward.lab.oracle;
