/** Common parts of several commands: messages of errors and their exit status, pages, the list of games. */
package steward.cli.shared;
