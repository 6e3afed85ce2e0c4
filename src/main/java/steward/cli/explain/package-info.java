/** The command {@code explain}: parts of a scene and their prices. */
package steward.cli.explain;
