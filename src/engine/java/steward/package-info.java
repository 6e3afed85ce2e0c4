/**
 * A game referee engine: matches between bot programs, advanced to the exact time of every impact, recorded and
 * verified.
 *
 * <p>The rooms, lowest first, are listed in CONTRIBUTING under "Where things are"; imports point only downward. Types
 * that users may build on are listed in {@code docs/api.md}; all others may change with any version.
 */
package steward;
