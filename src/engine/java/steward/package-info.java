/**
 * A game referee engine: matches between bot programs, advanced to the exact time of every impact, recorded and
 * verified.
 *
 * <p>The rooms, lowest first, are listed in the README under "Where things are"; imports point only downward. Rooms and
 * types that carry {@link steward.Internal} may change with any version; what users may build on is listed in
 * {@code docs/api.md}.
 */
package steward;
