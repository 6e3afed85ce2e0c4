/**
 * Files that a person named: paths as they were typed, output that replaces nothing unless told to, and the exception
 * for what cannot be used.
 */
@Internal
package steward.files;

import steward.Internal;
