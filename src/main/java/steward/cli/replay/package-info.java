/** Commands about recorded matches, and {@code key}, which makes the keys they are signed with. */
package steward.cli.replay;
