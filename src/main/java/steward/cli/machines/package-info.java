/** Commands that play a league on several machines. */
package steward.cli.machines;
