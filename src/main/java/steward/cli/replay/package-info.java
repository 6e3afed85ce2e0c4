/**
 * Commands about recorded matches: {@code replay}, {@code feed}, {@code import}; and {@code key}, which makes
 * the keys they are signed with.
 */
package steward.cli.replay;
