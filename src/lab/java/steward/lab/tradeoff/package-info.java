/**
 * Speed against accuracy: cost and errors of every rung, compared with the oracle on the same states in the same run.
 */
package steward.lab.tradeoff;
