/**
 * Speed against accuracy: errors of every rung against the oracle and their cost, on the same states in the same run.
 */
package steward.lab.tradeoff;
