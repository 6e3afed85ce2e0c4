package steward.scene.price;

import java.util.List;

/**
 * Prices measured on this machine.
 *
 * @param prices first that of the empty scene, then those of the physics' parts in their order, then those of the
 *               game's parts
 * @param turn   a turn of the whole scene, in nanoseconds
 * @param rounds how many rounds were used
 */
public record MeasuredPrices(List<PartPrice> prices, PartPrice turn, int rounds) { }
