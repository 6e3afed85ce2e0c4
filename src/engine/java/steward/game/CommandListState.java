package steward.game;

import steward.json.CommandsAnswer;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.JsonParser;

/** States of a game in which a player gives a list of commands, one for each of its bodies. */
public abstract class CommandListState<C> implements StateCodec {

    private final CommandsAnswer<C> commands;

    /** @param commands reads what was recorded */
    protected CommandListState(CommandsAnswer<C> commands) {
        this.commands = commands;
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
        return read(in, player, false);
    }

    @Override
    public final String readPartialCommand(JsonParser in, int player) {
        return read(in, player, true);
    }

    private String read(JsonParser in, int player, boolean partial) {
        expect(player);
        String wrong = commands.readArray(in, partial);
        for (int k = 0; wrong == null && k < commands(player); k++) {
            command(player, k, commands.command(k));
        }
        return wrong;
    }

    /** Says whose commands are read next, to a reader for which that matters. */
    protected void expect(int player) {
        // most players command as many bodies as any other
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
