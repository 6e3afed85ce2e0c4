/** The measured trade-off as CSV, JSON, plot and page. */
package steward.lab.tradeoff.report;
