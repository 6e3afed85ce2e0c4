/**
 * Projects on CodinGame's SDK as their authors publish them: building them, with an engine from its own repository if
 * need be, and reading their configuration and class files. Nothing is played here.
 */
package steward.guest.project;
