package steward.game.fantasticbits.protocol;

import java.util.Arrays;
import java.util.Locale;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import steward.game.fantasticbits.FantasticBits;
import steward.game.fantasticbits.Pitch;
import steward.game.fantasticbits.Spell;
import steward.game.fantasticbits.WizardCommand;
import steward.game.fantasticbits.WizardCommand.Action;
import steward.json.CommandsAnswer;
import steward.json.JsonNumbers;
import steward.text.NearestName;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.JsonParser;
import tools.jackson.core.JsonToken;

/**
 * JSON of the commands of two wizards in answers and replays, read, checked and written: {@code wizards}, an array of
 * two, each
 * <pre>{"x":1,"y":2,"power":150}   {"x":1,"y":2,"throw":500}   {"spell":"accio","target":5}</pre>
 */
final class FantasticBitsAnswer extends CommandsAnswer<WizardCommand> {

    private static final int MOST_ID = 999;
    private static final Set<String> SPELLS = Arrays.stream(Spell.values()).map(Spell::text)
        .collect(Collectors.toCollection(TreeSet::new));

    private final FantasticBits game;
    private double power;
    private double target;
    private Action action;
    private Spell spell;

    /** @param game whose state must allow what is read; {@code null} for commands that were recorded */
    FantasticBitsAnswer(FantasticBits game) {
        super("wizards", FARTHEST, "x", "y", "power", "throw", "spell", "target");
        this.game = game;
    }

    static void write(JsonGenerator out, WizardCommand command) {
        if (command.action() == Action.CAST) {
            out.writeStringProperty("spell", command.spell().text());
            out.writeNumberProperty("target", command.target());
        } else {
            JsonNumbers.write(out, "x", command.x());
            JsonNumbers.write(out, "y", command.y());
            JsonNumbers.write(out, command.action() == Action.MOVE ? "power" : "throw", command.power());
        }
    }

    @Override
    protected int count() {
        return Pitch.WIZARDS_PER_PLAYER;
    }

    @Override
    protected void beginCommand() {
        target = Double.NaN;
        action = null;
    }

    @Override
    protected String commandField(String field, JsonParser in) {
        switch (field) {
            case "power", "throw" -> {
                Action wanted = field.equals("power") ? Action.MOVE : Action.THROW;
                power = number(in) + 0.0;
                int most = WizardCommand.mostPower(wanted);
                return power >= 0 && power <= most ? act(field, wanted)
                    : field + ": found " + found(in) + ", expected a number 0.." + most;
            }
            case "spell" -> {
                String named = in.currentToken() == JsonToken.VALUE_STRING ? in.getString() : "";
                if (!SPELLS.contains(named)) {
                    return "spell: found " + found(in) + ", expected one of " + String.join(", ", SPELLS)
                        + NearestName.question(named, SPELLS, "");
                }
                spell = Spell.valueOf(named.toUpperCase(Locale.ROOT));
                return act(field, Action.CAST);
            }
            default -> {
                if (!Double.isNaN(target)) {
                    return "target: found twice, expected once";
                }
                target = number(in);
                return isWhole(target, -MOST_ID, MOST_ID) ? null
                    : "target: found " + found(in) + ", expected the id of an entity";
            }
        }
    }

    private String act(String field, Action wanted) {
        if (action != null) {
            return field + ": found more than one of power, throw, spell, expected exactly one";
        }
        action = wanted;
        return null;
    }

    @Override
    protected String endCommand(int index) {
        if (action == null) {
            return ": found none of power, throw, spell, expected exactly one";
        }
        String wrong = wrongBeside();
        if (wrong != null) {
            return wrong;
        }
        WizardCommand command = switch (action) {
            case CAST -> WizardCommand.cast(spell, (int) target);
            case THROW -> WizardCommand.toss(x + 0.0, y + 0.0, power);
            case MOVE -> WizardCommand.move(x + 0.0, y + 0.0, power);
        };
        String refusal = game == null ? null : game.refusal(player, index, command);
        return refusal == null ? keep(index, command) : (refusal.startsWith("found") ? ": " : ".") + refusal;
    }

    /** Returns the error in the fields beside the action: one is missing or too much. */
    private String wrongBeside() {
        if (action == Action.CAST) {
            return Double.isNaN(target) ? ".target: found nothing, expected a number" : targetBeside("spell");
        }
        String missing = missingTarget();
        return missing != null ? missing
            : Double.isNaN(target) ? null : ".target: found a number, expected nothing beside power or throw";
    }
}
