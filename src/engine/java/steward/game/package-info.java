/** Interfaces between a game and the rooms that play, record and draw it. No processes, deadlines or files. */
package steward.game;
