/** The measured trade-off as CSV, JSON, and plot. */
package steward.lab.tradeoff.report;
