/**
 * Common parts of several commands: streams and terminals, messages of errors and their exit status, the list of games.
 */
package steward.cli.shared;
