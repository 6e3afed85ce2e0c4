/**
 * The building blocks of stability cases: rungs, run lengths, findings, seeded pairs and gases, balances of energy and
 * momentum, and checks against the oracle.
 */
package steward.lab.trial;
