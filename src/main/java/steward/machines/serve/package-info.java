/** The league's side of games that are played elsewhere: jobs, workers, and what becomes of what they say. */
package steward.machines.serve;
