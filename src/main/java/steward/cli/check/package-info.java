/** {@code steward check}: one bot tried alone, with the reason where it fails and what to do about it. */
@Internal
package steward.cli.check;

import steward.Internal;
