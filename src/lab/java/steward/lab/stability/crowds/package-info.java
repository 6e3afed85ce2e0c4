/**
 * Cases of the stability table with many bodies: gases, lattices, chains, dense packings, long runs.
 */
@Internal
package steward.lab.stability.crowds;

import steward.Internal;
