/** Stability cases of bodies under forces or with restitution below 1: they bounce, fall and come to rest. */
package steward.lab.stability.bodies;
