/** {@code steward check}: one bot is tried alone; if it fails, the reason and advice are printed. */
package steward.cli.check;
