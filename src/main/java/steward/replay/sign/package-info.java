/** Signatures: keys in files, what of a replay is signed, and Ed25519 over it. */
package steward.replay.sign;
