/** Speed against accuracy: error of every rung against the oracle and its cost, on the same states in one run. */
package steward.lab.tradeoff;
