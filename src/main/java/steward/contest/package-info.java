/**
 * Play of bots against each other, with their seeds and limits: one game or many, on threads, recorded or not; how each
 * bot did, how long it took to answer and why it failed; and the replays that are kept. It does not use the terminal:
 * results are returned, unusable input is thrown as an exception.
 */
package steward.contest;
