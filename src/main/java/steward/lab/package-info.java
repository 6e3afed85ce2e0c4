/**
 * Where the engine is held against the truth: an oracle that computes a turn in 64 decimal digits, the cases of the
 * stability table and the random campaigns, and the golden hash that must be the same on every machine. The oracle
 * reads the plain data of a scene (bodies, walls, law) and shares no code with the physics it judges. No bots here.
 */
package steward.lab;
