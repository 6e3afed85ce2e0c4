/** Watching a match while it is played: a small server for browsers, of which none delays the match. */
package steward.live;
