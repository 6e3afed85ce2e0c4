/**
 * The formats of CodinGame and of the tools around it: the server's own recordings of the pod race, its game result,
 * the protocols by which match runners call a referee. It stands above replays and below the command line; the pod
 * race is the only game it knows, because that is what those recordings hold.
 */
package steward.codingame;
