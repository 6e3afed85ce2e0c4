/** {@code steward check}: one bot tried alone, with the reason where it fails and what to do about it. */
package steward.cli.check;
