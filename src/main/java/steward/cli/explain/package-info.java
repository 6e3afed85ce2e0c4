/** The command {@code explain}: contents of a scene and the parts of the engine that it needs. */
package steward.cli.explain;
