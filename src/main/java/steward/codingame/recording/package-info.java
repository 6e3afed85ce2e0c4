/** Recordings of games that CodinGame's server refereed: read, played again and written as replays. */
package steward.codingame.recording;
