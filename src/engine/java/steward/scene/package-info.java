/**
 * Scene files, read and checked. The common blocks are read here, a game's own blocks by the game through
 * {@link steward.scene.json.Block}; {@link steward.scene.Plan} decides which parts of the engine the scene needs. No
 * particular game, no bots.
 */
package steward.scene;
