package steward.bot;

/**
 * A bot that used the processor while another bot was asked, which then was late.
 *
 * @param player     its place in the game
 * @param processors how many it used on average, over the last 100 ms of such time
 * @param holdable   whether it can be held on this machine
 */
public record Burner(int player, double processors, boolean holdable) { }
