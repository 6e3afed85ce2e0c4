/**
 * The harness of every measurement: kinds of work are timed against each other in rounds that go from one to the next,
 * by the clock of a thread, of the JVM or of the wall. Each has a place of its own: in this JVM, or in another that is
 * started from the same class path, as a match loads one; it is warmed up until times are steady.
 */
package steward.lab.timing;
