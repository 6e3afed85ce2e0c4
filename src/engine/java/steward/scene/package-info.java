/** Scene files, read and checked, and the parts of the engine that a scene needs. No particular game, no bots. */
package steward.scene;
