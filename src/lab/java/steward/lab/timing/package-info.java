/**
 * Times kinds of turns against each other, each in a JVM of its own, as a match loads one: started from the same class
 * path, warmed up until times are steady, measured in rounds that go from one JVM to the next.
 */
package steward.lab.timing;
