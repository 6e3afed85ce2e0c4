/** Cases of the stability table with many bodies: gases, lattices, chains, dense packings, long runs. */
package steward.lab.stability.crowds;
