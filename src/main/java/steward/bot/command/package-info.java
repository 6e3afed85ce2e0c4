/**
 * How a person names a bot: a command line split as a shell would, prefixes for the protocol, the bots that come with
 * the program, and finding the program.
 */
@Internal
package steward.bot.command;

import steward.Internal;
