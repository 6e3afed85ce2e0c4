/**
 * JSON that a person wrote, read with the line and column of every value. So every error is a {@link
 * steward.scene.json.SceneException} that says where, what was found and what was expected.
 */
package steward.scene.json;
