/** JSON that a person wrote, read with the line and column of every value, for errors that say where. */
package steward.scene.json;
