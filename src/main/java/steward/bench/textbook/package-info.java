/** Plain textbook implementations as a baseline; they share no code with the engine. */
@Internal
package steward.bench.textbook;

import steward.Internal;
