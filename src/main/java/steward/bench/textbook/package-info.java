/**
 * Plain textbook ways of doing the same, to measure against; they share no code with the engine.
 */
@Internal
package steward.bench.textbook;

import steward.Internal;
