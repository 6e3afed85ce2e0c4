/** Options that several commands have, with their checks and error messages. */
package steward.cli.options;
