/** The commands of {@code steward league}, and what they print. */
package steward.cli.league;
