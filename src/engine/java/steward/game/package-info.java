/**
 * The interfaces between a game and the other packages. Packages above play, record and draw any game through them;
 * packages below know of no game. Particular games live in sub-packages. Processes, deadlines and files are not known
 * here.
 */
package steward.game;
