/** Sections of the bench: matches, verification, processes, start-up, tools of others, crowds, heaps. */
package steward.lab.bench.section;
