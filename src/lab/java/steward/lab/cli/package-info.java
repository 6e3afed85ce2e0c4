/** Commands that measure accuracy: {@code explain}, {@code tradeoff}, {@code stability}. */
package steward.lab.cli;
