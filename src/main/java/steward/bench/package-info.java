/**
 * Measuring whole things: sections of contenders, rows of figures, meters, and the files and page they are kept in.
 */
@Internal
package steward.bench;

import steward.Internal;
