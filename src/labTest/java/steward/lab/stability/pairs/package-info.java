/**
 * Cases of the stability table with one body or two: grazing, extreme speeds, masses and radii, corners, late times.
 */
package steward.lab.stability.pairs;
