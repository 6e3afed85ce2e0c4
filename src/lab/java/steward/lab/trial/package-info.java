/** Building blocks of stability cases: rungs, run lengths, findings, seeded pairs and gases, balances, checks. */
package steward.lab.trial;
