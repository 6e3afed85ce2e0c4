/**
 * Scene files: what a person wrote about a match, read, checked and located. The common blocks are read here, a game's
 * own blocks by the game through {@link steward.scene.json.Block}; {@link steward.scene.Plan} decides which parts of the
 * engine the scene needs. No particular game, no bots.
 *
 * <p>Whatever is wrong in a file ends in a {@link steward.scene.json.SceneException} that says where, what was found and
 * what was expected.
 */
package steward.scene;
