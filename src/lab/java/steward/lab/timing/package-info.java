/**
 * Harness of every measurement: kinds of work are timed against each other in alternating rounds. The clock is that of
 * a thread, of the JVM or of the wall. Each kind is timed in this JVM or in another one, which is started from the same
 * class path, as a match loads one. It is warmed up until times are steady.
 */
package steward.lab.timing;
