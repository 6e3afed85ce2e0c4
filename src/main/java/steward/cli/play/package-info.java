/**
 * Commands that play matches: {@code match}, {@code play}, {@code referee}, {@code demo}, {@code simulate}.
 */
@Internal
package steward.cli.play;

import steward.Internal;
