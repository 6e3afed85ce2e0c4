/** A replay as one self-contained page that a browser draws. */
package steward.replay.page;
