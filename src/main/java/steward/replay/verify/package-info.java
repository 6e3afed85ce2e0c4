/**
 * Playing a recorded match again and comparing every turn with what was recorded, to the bit; the first difference is
 * named.
 */
package steward.replay.verify;
