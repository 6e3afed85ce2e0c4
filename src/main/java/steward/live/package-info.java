/**
 * Watching a match while it is played. It has the lines kept for all viewers, a small server on this machine that sends
 * them to browsers, and the browser itself. A viewer, however slow, never delays the match.
 */
package steward.live;
