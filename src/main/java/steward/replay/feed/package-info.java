/** Sending a bot again what it was sent in a match: to compare its answers, or to let it play on from any turn. */
package steward.replay.feed;
