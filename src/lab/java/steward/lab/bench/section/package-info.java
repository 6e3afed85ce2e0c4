/** Sections of the bench: matches, frames, crowds, processes, start-up, verification, growth. */
package steward.lab.bench.section;
