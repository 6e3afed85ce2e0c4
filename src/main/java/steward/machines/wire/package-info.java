/** What a league and its workers send each other: a header in JSON, read strictly, and bytes behind it. */
@Internal
package steward.machines.wire;

import steward.Internal;
