/** Commands that measure: {@code stability}, {@code tradeoff}, {@code bench}. */
package steward.lab.cli;
