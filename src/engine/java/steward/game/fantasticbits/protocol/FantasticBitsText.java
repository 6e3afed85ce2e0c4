package steward.game.fantasticbits.protocol;

import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import steward.game.CommandLines;
import steward.game.fantasticbits.EntityKind;
import steward.game.fantasticbits.FantasticBits;
import steward.game.fantasticbits.Pitch;
import steward.game.fantasticbits.Spell;
import steward.game.fantasticbits.Variant;
import steward.game.fantasticbits.WizardCommand;
import steward.physics.Bodies;
import steward.physics.Motion;

/**
 * Line protocol of the site for Fantastic Bits. The setup is the player's index. A turn is, in the variant {@code
 * puzzle} only, {@code score magic} of the reader and of the other; the number of entities; and a line {@code id TYPE x
 * y vx vy state} for each: the reader's wizards, the other's, snaffles in play, bludgers. The answer is two lines,
 * {@code MOVE X Y THRUST}, {@code THROW X Y POWER} or a spell and the id of its target, each with an optional message.
 * Lines before a bad one take effect.
 */
final class FantasticBitsText extends CommandLines {

    private static final Pattern PLACE =
        Pattern.compile("(MOVE|THROW) (-?[0-9]{1,8})\\s+(-?[0-9]{1,8})\\s+([0-9]{1,8})(?:\\s+(.+))?");
    private static final Pattern CAST =
        Pattern.compile("(ACCIO|FLIPENDO|OBLIVIATE|PETRIFICUS) (-?[0-9]{1,3})(?:\\s+(.+))?");

    private final FantasticBits game;
    private final boolean full;

    FantasticBitsText(FantasticBits game) {
        super(game.players());
        this.game = game;
        full = game.settings().variant() == Variant.PUZZLE;
    }

    @Override
    public void writeSetup(StringBuilder out, int player) {
        out.append(player).append('\n');
    }

    @Override
    public void writeTurn(StringBuilder out, int player) {
        if (full) {
            out.append(game.score(player)).append(' ').append(game.magic(player)).append('\n');
            out.append(game.score(1 - player)).append(' ').append(game.magic(1 - player)).append('\n');
        }
        Pitch pitch = game.pitch();
        int lost = 0;
        for (int k = 0; k < pitch.entities(); k++) {
            lost += pitch.kind(k) == EntityKind.LOST_SNAFFLE ? 1 : 0;
        }
        out.append(pitch.entities() - lost).append('\n');
        for (int k = 0; k < pitch.entities(); k++) {
            boolean wizard = k < Pitch.WIZARDS;
            int entity = wizard ? (k + player * Pitch.WIZARDS_PER_PLAYER) % Pitch.WIZARDS : k;
            writeEntity(out, pitch, entity, wizard && Pitch.playerOf(entity) != player ? "OPPONENT_" : "");
        }
    }

    private void writeEntity(StringBuilder out, Pitch pitch, int entity, String whose) {
        Bodies bodies = pitch.bodies();
        EntityKind kind = pitch.kind(entity);
        if (kind == EntityKind.LOST_SNAFFLE) {
            return;
        }
        out.append(bodies.id(entity)).append(' ').append(whose).append(kind.text().toUpperCase(Locale.ROOT)).append(' ')
            .append((long) Math.floor(bodies.x[entity] + 0.5)).append(' ')
            .append((long) Math.floor(bodies.y[entity] + 0.5)).append(' ')
            .append((long) Motion.roundHalfAway(bodies.vx[entity])).append(' ')
            .append((long) Motion.roundHalfAway(bodies.vy[entity])).append(' ').append(switch (kind) {
                case WIZARD -> pitch.held(entity) >= 0 ? 1 : 0;
                case HELD_SNAFFLE -> full ? 1 : 0;
                case BLUDGER -> full ? (int) bodies.columns[Pitch.LAST_VICTIM][entity] : 0;
                default -> 0;
            }).append('\n');
    }

    @Override
    public int answerLines(int player) {
        return Pitch.WIZARDS_PER_PLAYER;
    }

    @Override
    protected String read(String line, int player, int wizard, List<String> said) {
        WizardCommand command = command(withoutReturn(line), said);
        if (command == null) {
            return notFound("MOVE X Y THRUST, THROW X Y POWER, or a spell and a target's id, whole numbers",
                withoutReturn(line));
        }
        String refusal = game.refusal(player, wizard, command);
        if (refusal == null) {
            game.command(player, wizard, command);
        }
        return refusal;
    }

    private static WizardCommand command(String line, List<String> said) {
        Matcher place = PLACE.matcher(line);
        if (place.matches()) {
            say(place.group(5), said);
            int x = Integer.parseInt(place.group(2));
            int y = Integer.parseInt(place.group(3));
            int power = Integer.parseInt(place.group(4));
            return place.group(1).equals("MOVE") ? WizardCommand.move(x, y, power) : WizardCommand.toss(x, y, power);
        }
        Matcher cast = CAST.matcher(line);
        if (cast.matches()) {
            say(cast.group(3), said);
            return WizardCommand.cast(Spell.valueOf(cast.group(1)), Integer.parseInt(cast.group(2)));
        }
        return null;
    }
}
