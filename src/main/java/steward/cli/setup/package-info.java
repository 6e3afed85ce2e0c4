/**
 * Commands for beginners: {@code new} writes a bot to start from, {@code doctor} reports what works on this machine,
 * {@code adopt} writes a scene for a published referee.
 */
package steward.cli.setup;
