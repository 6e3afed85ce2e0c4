/**
 * The measured trade-off as CSV, JSON, plot and page.
 */
@Internal
package steward.lab.tradeoff.report;

import steward.Internal;
