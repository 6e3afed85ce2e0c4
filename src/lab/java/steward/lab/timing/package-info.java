/** Times kinds of turns against each other, each in a JVM of its own that is warmed up, in turns. */
package steward.lab.timing;
