/**
 * Cases of the stability table with one body or two: grazing, extreme speeds, masses and radii, corners, late times.
 */
@Internal
package steward.lab.stability.pairs;

import steward.Internal;
