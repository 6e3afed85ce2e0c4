package steward.game;

import steward.json.JsonNumbers;

/**
 * JSON of one game, bound to one {@link Game}: what its players read and write, what a replay keeps, and what is drawn.
 * The {@code write} methods of all three add fields to an object that the caller has opened and closes; numbers go
 * through {@link JsonNumbers}.
 *
 * @param frames  what bots are sent and answer; {@code null} where they speak lines only
 * @param state   commands and states, as a replay keeps them
 * @param drawing what there is to draw
 */
public record FrameCodec(BotFrames frames, StateCodec state, Drawing drawing) { }
