/** Options that several commands have, with the checks and the words that refuse a wrong call. */
package steward.cli.options;
