/**
 * Playing a recorded match again and comparing every turn with the recording, to the bit; the first difference is
 * named.
 */
package steward.replay.verify;
