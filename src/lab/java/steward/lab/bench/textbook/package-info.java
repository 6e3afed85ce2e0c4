/** Plain textbook implementations as a baseline; they share no code with the engine but sine and cosine. */
package steward.lab.bench.textbook;
