/**
 * Signatures: keys in files, what of a replay is signed, and Ed25519 over it. It knows lines of bytes, not what stands
 * in them.
 */
package steward.replay.sign;
