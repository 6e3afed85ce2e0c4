/** The resident referee: matches of many calls in one JVM, for clients that are no JVMs ({@code client.c}). */
package steward.cli.resident;
