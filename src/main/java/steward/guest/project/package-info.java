/**
 * Published referee projects on CodinGame's SDK: building them, and reading their configuration and class files. If
 * need be, the engine is built from its own repository. Nothing is played here.
 */
package steward.guest.project;
