package steward.scene;

/**
 * A part of the engine that a scene may need.
 *
 * @param name what it is
 * @param in   whether the scene needs it; what is left out costs nothing
 * @param why  what in the scene asks for it, or what is absent
 */
public record Part(String name, boolean in, String why) {
}
