/**
 * The game {@code bodies}, the smallest whole one: discs that somebody lists or lays out, with walls, forces and zones,
 * with or without players. Rules free of JSON.
 */
package steward.game.bodies;

