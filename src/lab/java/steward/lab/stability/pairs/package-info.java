/** Cases of the stability table with one body or two: grazing, extremes of numbers, corners, late times. */
package steward.lab.stability.pairs;
