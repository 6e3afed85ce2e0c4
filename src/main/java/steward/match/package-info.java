/** The referee loop for any number of players, and the result of a match; not how matches are stored. */
package steward.match;
