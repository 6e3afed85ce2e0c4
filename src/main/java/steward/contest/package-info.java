/**
 * Playing bots against each other: one game or many, with seeds and limits, on threads, with replays or without. It
 * collects how each bot did, how long it took to answer, why it failed, and which replays are kept. It does not use the
 * terminal: results are returned, unusable input is thrown as an exception.
 */
package steward.contest;
