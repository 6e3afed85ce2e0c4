/** Shared parts of several commands: error messages and exit statuses, pages, the list of games. */
package steward.cli.shared;
