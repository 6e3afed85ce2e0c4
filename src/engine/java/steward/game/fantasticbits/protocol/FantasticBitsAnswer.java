package steward.game.fantasticbits.protocol;

import steward.game.JsonAnswer;
import steward.game.fantasticbits.FantasticBits;
import steward.game.fantasticbits.Pitch;
import tools.jackson.core.JsonParser;

/** Reads one answer of a Fantastic Bits bot: the commands as {@link WizardCommandJson} and an optional message. */
final class FantasticBitsAnswer extends JsonAnswer {

    private final WizardCommandJson commands;
    private int player;
    private boolean given;

    FantasticBitsAnswer(FantasticBits game) {
        super("wizards");
        commands = new WizardCommandJson(game);
    }

    /** The commands of the last valid answer. */
    WizardCommandJson commands() {
        return commands;
    }

    /** Reads a player's answer: what is allowed depends on the player. @return as {@link #read} */
    String read(int of, byte[] line, int length) {
        player = of;
        return read(line, length);
    }

    @Override
    protected void begin() {
        given = false;
    }

    @Override
    protected String field(String name, JsonParser in) {
        if (given) {
            return "wizards: found twice, expected once";
        }
        given = true;
        return commands.read(in, player, false);
    }

    @Override
    protected String complete() {
        return given ? null : "wizards: found nothing, expected an array of " + Pitch.WIZARDS_PER_PLAYER;
    }
}
