/**
 * The interfaces between a game and the other rooms. The rooms above play, record and draw any game through them; the
 * rooms below know of none. Particular games live in sub-packages. Processes, deadlines and files are not known here.
 */
package steward.game;
