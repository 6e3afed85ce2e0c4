/** The command {@code bench}, and its bots for the pod race. */
package steward.lab.cli.bench;
