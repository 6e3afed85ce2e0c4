/**
 * Options that several commands have, with the checks and the words that refuse a wrong call: each stands here once.
 */
package steward.cli.options;
