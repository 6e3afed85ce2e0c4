/**
 * Signatures of replays: keys in files, the signed part of a replay, and Ed25519 over it. It knows lines of bytes, not
 * their contents.
 */
package steward.replay.sign;
