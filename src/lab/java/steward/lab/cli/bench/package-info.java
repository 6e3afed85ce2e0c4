/** The command {@code bench}, and the contenders for the pod race. */
package steward.lab.cli.bench;
