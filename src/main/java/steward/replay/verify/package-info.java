/** Playing a recorded match again and comparing every turn with the recorded one, to the bit. */
package steward.replay.verify;
