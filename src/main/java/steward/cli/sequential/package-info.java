/** Tests that stop, and tuning: one small class per command, and what they have in common. */
@Internal
package steward.cli.sequential;

import steward.Internal;
