/**
 * Commands that measure accuracy: {@code explain}, {@code tradeoff}, {@code stability}.
 */
@Internal
package steward.lab.cli;

import steward.Internal;
