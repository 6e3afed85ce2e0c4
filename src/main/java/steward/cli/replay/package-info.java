/**
 * Commands about recorded matches: {@code replay}, {@code feed}, {@code import}; and {@code key}, which makes the keys
 * that sign them.
 */
package steward.cli.replay;
