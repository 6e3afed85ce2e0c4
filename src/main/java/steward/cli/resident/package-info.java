/** The resident referee: one JVM that plays the matches of many calls, for native clients ({@code client.c}). */
package steward.cli.resident;
