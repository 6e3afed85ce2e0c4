/**
 * What a case of the stability table is made of: rungs, run lengths, findings, seeded pairs and gases, books of energy
 * and momentum, and checks against the oracle.
 */
@Internal
package steward.lab.trial;

import steward.Internal;
