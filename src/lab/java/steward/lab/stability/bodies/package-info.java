/** Cases of the stability table about bodies that bounce, come to rest, or are accelerated by forces. */
package steward.lab.stability.bodies;
