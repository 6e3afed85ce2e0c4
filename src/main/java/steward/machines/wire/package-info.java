/** What a league and its workers send each other: a header in JSON, read as strictly as a file of a person, and bytes. */
@Internal
package steward.machines.wire;

import steward.Internal;
