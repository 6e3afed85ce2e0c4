/** The league's side of remote games: jobs, workers, and checks of what workers report. */
package steward.machines.serve;
