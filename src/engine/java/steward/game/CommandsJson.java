package steward.game;

import steward.json.CommandsAnswer;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.JsonParser;

/** Base class of a game's JSON if a player gives a list of commands, one for each of its bodies. */
public abstract class CommandsJson<C> implements GameJson {

    private final CommandsAnswer<C> answers;
    private final CommandsAnswer<C> recorded;
    private final String[] messages;

    /**
     * JSON of a game of so many players.
     *
     * @param answers  reads what bots answer
     * @param recorded reads what a replay has kept
     */
    protected CommandsJson(int players, CommandsAnswer<C> answers, CommandsAnswer<C> recorded) {
        this.answers = answers;
        this.recorded = recorded;
        messages = new String[players];
    }

    /** The number of bodies that the player commands. */
    protected abstract int commands(int player);

    /** The command of a body for the turn about to be played, or {@code null}. */
    protected abstract C command(int player, int index);

    /** Gives a body a command, or none for {@code null}. */
    protected abstract void command(int player, int index, C command);

    /** Writes the fields of a command. */
    protected abstract void writeFields(JsonGenerator out, C command);

    @Override
    public final String readAnswer(int player, byte[] line, int length) {
        String wrong = answers.of(player).read(line, length);
        messages[player] = wrong == null ? answers.message() : null;
        return take(player, wrong, answers);
    }

    @Override
    public final String message(int player) {
        return messages[player];
    }

    @Override
    public final void writeCommand(JsonGenerator out, int player) {
        out.writeStartArray();
        for (int k = 0; k < commands(player); k++) {
            C command = command(player, k);
            if (command == null) {
                out.writeNull();
            } else {
                out.writeStartObject();
                writeFields(out, command);
                out.writeEndObject();
            }
        }
        out.writeEndArray();
    }

    @Override
    public final String readCommand(JsonParser in, int player) {
        return take(player, recorded.of(player).readArray(in, false), recorded);
    }

    @Override
    public final String readPartialCommand(JsonParser in, int player) {
        return take(player, recorded.of(player).readArray(in, true), recorded);
    }

    private String take(int player, String wrong, CommandsAnswer<C> read) {
        for (int k = 0; wrong == null && k < commands(player); k++) {
            command(player, k, read.command(k));
        }
        return wrong;
    }

    @Override
    public final boolean hasPartialCommand(int player) {
        return commands(player) > 0 && command(player, 0) != null;
    }

    @Override
    public final void clearCommand(int player) {
        for (int k = 0; k < commands(player); k++) {
            command(player, k, null);
        }
    }
}
