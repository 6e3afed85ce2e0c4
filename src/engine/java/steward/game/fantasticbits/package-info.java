/**
 * Rules of Fantastic Bits, free of JSON, and the published referee's own expressions for its motion. Two players with
 * two wizards each play with snaffles, bludgers, goals in the walls and spells ({@link
 * steward.game.fantasticbits.OfficialFantasticBits}).
 */
package steward.game.fantasticbits;
