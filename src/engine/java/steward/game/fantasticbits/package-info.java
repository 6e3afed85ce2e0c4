/**
 * The rules of Fantastic Bits, free of JSON: two players with two wizards each, snaffles, bludgers, goals in the walls
 * and spells; and the published referee's own expressions for its motion
 * ({@link steward.game.fantasticbits.OfficialFantasticBits}).
 */
package steward.game.fantasticbits;
