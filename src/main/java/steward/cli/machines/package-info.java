/** The commands that play a league on several machines. */
@Internal
package steward.cli.machines;

import steward.Internal;
