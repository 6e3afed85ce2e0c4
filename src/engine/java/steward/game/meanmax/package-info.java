/**
 * The rules of Mean Max, free of JSON: three players, each with a reaper, a destroyer and a doof, in a round arena with
 * tankers, wrecks and skill effects; and the published referee's own expressions for its motion
 * ({@link steward.game.meanmax.OfficialMeanMax}).
 */
package steward.game.meanmax;
