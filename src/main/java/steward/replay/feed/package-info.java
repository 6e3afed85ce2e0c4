/** Giving a bot again what it was sent, to see whether it answers the same, and letting it play on from any turn. */
package steward.replay.feed;
