/** Commands of sequential tests and of tuning, with their shared parts. */
package steward.cli.sequential;
