/**
 * Recordings of games that CodinGame's server refereed: read in each of its formats, played again and written as
 * replays.
 */
package steward.codingame.recording;
