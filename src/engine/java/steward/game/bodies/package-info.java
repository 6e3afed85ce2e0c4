/**
 * The game {@code bodies}, the smallest whole one: listed or laid-out discs, with walls, forces and zones, with or
 * without players. Rules free of JSON.
 */
package steward.game.bodies;

