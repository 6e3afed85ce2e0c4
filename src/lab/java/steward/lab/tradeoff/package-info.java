/**
 * Speed against accuracy: errors of every rung against the oracle and their cost, on the same states in the same run.
 */
@Internal
package steward.lab.tradeoff;

import steward.Internal;
