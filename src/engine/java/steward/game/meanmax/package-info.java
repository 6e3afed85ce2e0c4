/**
 * Rules of Mean Max, free of JSON, and the published referee's own expressions for its motion. Three players, each with
 * a reaper, a destroyer and a doof, play in a round arena with tankers, wrecks and skill effects ({@link
 * steward.game.meanmax.OfficialMeanMax}).
 */
package steward.game.meanmax;
