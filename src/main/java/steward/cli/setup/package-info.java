/**
 * Commands for beginners: {@code new} writes a bot to start from, {@code doctor} says what works on this
 * machine.
 */
@Internal
package steward.cli.setup;

import steward.Internal;
