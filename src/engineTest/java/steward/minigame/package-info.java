/**
 * A small game that is only there to prove the house: everything a game can ask of it, in a circular pond. It needed no
 * change in {@code physics}, {@code match}, {@code bot} or {@code replay}.
 *
 * <p>Three hunters push themselves about. A bubble bursts at their touch and does not slow them down. A cell splits in
 * two at their touch until it is small enough to be eaten; who eats grows. A hunter a quarter heavier than another eats
 * it, and its player is out; others bounce. Fog is only passed through. The heaviest wins.
 */
package steward.minigame;
