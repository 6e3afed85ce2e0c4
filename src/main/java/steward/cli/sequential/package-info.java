/** Tests that stop, and tuning: one small class per command, and what they have in common. */
package steward.cli.sequential;
