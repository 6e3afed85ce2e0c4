/** Lines of JSON that programs exchange, to the last digit. That of people is read in {@code steward.scene.json}. */
package steward.json;
