/**
 * Scene files, read and checked. The common blocks are read here, a game's own blocks by the game through {@link
 * steward.scene.json.Block}; {@link steward.scene.Plan} decides which parts of the engine the scene needs. It knows no
 * particular game and no bots.
 */
package steward.scene;
