/** The terminal: streams, colours, logs, lines of progress, JSON on the standard output, interruptions. */
package steward.cli.streams;
