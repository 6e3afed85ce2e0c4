/**
 * Commands for beginners: {@code new} writes a bot to start from, {@code doctor} says what works on this
 * machine.
 */
package steward.cli.setup;
