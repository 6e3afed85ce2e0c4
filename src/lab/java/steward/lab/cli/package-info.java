/** Commands that measure: {@code tradeoff}, {@code bench}. */
package steward.lab.cli;
