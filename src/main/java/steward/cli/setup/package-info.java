/** Commands for beginners: {@code new} writes a bot to start from, {@code doctor} says what works here. */
package steward.cli.setup;
