/** Messages between a league and its workers: a header in JSON, read strictly, and bytes behind it. */
@Internal
package steward.machines.wire;

import steward.Internal;
