/** The command {@code explain}: parts of a scene. */
package steward.cli.explain;
