/**
 * Commands that measure accuracy: {@code explain}, {@code tradeoff}, {@code stability}.
 */
@Internal
package steward.cli.lab;

import steward.Internal;
