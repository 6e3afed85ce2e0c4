/**
 * Who plays whom with which seeds and limits: one game or many, on threads, recorded or not; how each bot did, how
 * long it took to answer and why it failed; which replays are kept. It knows no terminal: what it finds it returns, and
 * what cannot be used it throws.
 */
package steward.contest;
