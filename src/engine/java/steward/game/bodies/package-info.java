/** Rules of the game {@code bodies}, free of JSON: discs with walls, forces and zones, with or without players. */
package steward.game.bodies;

