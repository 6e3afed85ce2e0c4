package steward.game;

import java.util.function.Supplier;

/** Base class of game types: one list declares what a game is called, who plays it and what its bots read and say. */
public abstract class AbstractGameType implements GameType {

    private final String id;
    private final String about;
    private final String weakestBot;
    private final int fewestPlayers;
    private final int mostPlayers;
    private final Supplier<BotStub> lines;
    private final Supplier<BotStub> frames;

    /**
     * @param about         says it in a few words
     * @param weakestBot    of its bundled bots, or {@code null} if there is none
     * @param fewestPlayers of a scene, as {@code mostPlayers}
     * @param lines         what bots of its lines read and write, as {@code frames} of its JSON
     */
    protected AbstractGameType(String id, String about, String weakestBot, int fewestPlayers, int mostPlayers,
                          Supplier<BotStub> lines, Supplier<BotStub> frames) {
        this.id = id;
        this.about = about;
        this.weakestBot = weakestBot;
        this.fewestPlayers = fewestPlayers;
        this.mostPlayers = mostPlayers;
        this.lines = lines;
        this.frames = frames;
    }

    @Override
    public final String id() {
        return id;
    }

    @Override
    public final String about() {
        return about;
    }

    @Override
    public final String weakestBot() {
        return weakestBot;
    }

    @Override
    public final int fewestPlayers() {
        return fewestPlayers;
    }

    @Override
    public final int mostPlayers() {
        return mostPlayers;
    }

    @Override
    public final BotStub lineStub() {
        return lines.get();
    }

    @Override
    public final BotStub frameStub() {
        return frames.get();
    }
}
