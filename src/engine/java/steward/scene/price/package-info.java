/** Prices of the parts of a scene, as they are stored with the program or measured by the lab. */
package steward.scene.price;
