/**
 * Commands about recorded matches: {@code replay}, {@code feed}, {@code import}.
 */
@Internal
package steward.cli.replay;

import steward.Internal;
