package steward.game.fantasticbits.protocol;

import java.util.Locale;
import java.util.Set;
import java.util.TreeSet;
import steward.game.JsonNumbers;
import steward.game.fantasticbits.FantasticBits;
import steward.game.fantasticbits.Pitch;
import steward.game.fantasticbits.Spell;
import steward.game.fantasticbits.WizardCommand;
import steward.game.fantasticbits.WizardCommand.Action;
import steward.text.NearestName;
import steward.text.TextFormat;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.JsonParser;
import tools.jackson.core.JsonToken;

/**
 * The commands of a player's two wizards as JSON, in answers and replays: an array of two, each
 * <pre>{"x":1,"y":2,"power":150}   {"x":1,"y":2,"throw":500}   {"spell":"accio","target":5}</pre>
 * An error is returned as a sentence, because a wrong answer is frequent and not an exception.
 */
final class WizardCommandJson {

    /** The greatest coordinate of a target, in u. */
    private static final double FARTHEST = 1e9;
    private static final int MOST_ID = 999;
    private static final Set<String> FIELDS = new TreeSet<>(Set.of("x", "y", "power", "throw", "spell", "target"));
    private static final Set<String> SPELLS = new TreeSet<>();

    static {
        for (Spell spell : Spell.values()) {
            SPELLS.add(spell.text());
        }
    }

    /** {@code null} where commands need not be allowed by the state. */
    private final FantasticBits game;
    private final WizardCommand[] read = new WizardCommand[Pitch.WIZARDS_PER_PLAYER];

    private double x;
    private double y;
    private double power;
    private double target;
    private Action action;
    private Spell spell;

    /** @param game whose state must allow what is read; {@code null} for commands that were recorded */
    WizardCommandJson(FantasticBits game) {
        this.game = game;
    }

    /** The command last read for a wizard, or {@code null}. */
    WizardCommand command(int wizard) {
        return read[wizard];
    }

    static void write(JsonGenerator out, WizardCommand command) {
        if (command == null) {
            out.writeNull();
            return;
        }
        out.writeStartObject();
        if (command.action() == Action.CAST) {
            out.writeStringProperty("spell", command.spell().text());
            out.writeNumberProperty("target", command.target());
        } else {
            JsonNumbers.write(out, "x", command.x());
            JsonNumbers.write(out, "y", command.y());
            JsonNumbers.write(out, command.action() == Action.MOVE ? "power" : "throw", command.power());
        }
        out.writeEndObject();
    }

    /**
     * Reads the array; the parser stands on its first token.
     *
     * @param partial whether it is what a faulty answer gave: the first command, and then null
     * @return what is wrong, or {@code null}
     */
    String read(JsonParser in, int player, boolean partial) {
        if (in.currentToken() != JsonToken.START_ARRAY) {
            return "wizards: found " + describe(in) + ", expected an array of " + read.length;
        }
        int count = 0;
        while (in.nextToken() != JsonToken.END_ARRAY) {
            if (count == read.length) {
                return "wizards: found more than " + read.length + ", expected " + read.length;
            }
            read[count] = null;
            boolean none = partial && count > 0;
            if (none && in.currentToken() != JsonToken.VALUE_NULL) {
                return path(count) + ": found " + describe(in) + ", expected null";
            }
            String wrong = none ? null : readOne(in, player, count);
            if (wrong != null) {
                return wrong;
            }
            count++;
        }
        return count == read.length ? null : "wizards: found " + count + ", expected " + read.length;
    }

    private String readOne(JsonParser in, int player, int wizard) {
        if (in.currentToken() != JsonToken.START_OBJECT) {
            return path(wizard) + ": found " + describe(in) + ", expected an object";
        }
        x = Double.NaN;
        y = Double.NaN;
        target = Double.NaN;
        action = null;
        while (in.nextToken() == JsonToken.PROPERTY_NAME) {
            String name = in.currentName();
            in.nextToken();
            String wrong = readField(in, name);
            if (wrong != null) {
                return path(wizard) + "." + wrong;
            }
        }
        if (action == null) {
            return path(wizard) + ": found none of power, throw, spell, expected exactly one";
        }
        String wrong = wrongBeside();
        if (wrong != null) {
            return path(wizard) + wrong;
        }
        WizardCommand command = action == Action.CAST ? WizardCommand.cast(spell, (int) target)
            : action == Action.THROW ? WizardCommand.toss(x, y, power) : WizardCommand.move(x, y, power);
        String refusal = game == null ? null : game.refusal(player, wizard, command);
        if (refusal != null) {
            return path(wizard) + (refusal.startsWith("found") ? ": " : ".") + refusal;
        }
        read[wizard] = command;
        return null;
    }

    /** What is missing or too much beside the action. */
    private String wrongBeside() {
        boolean casts = action == Action.CAST;
        if (casts ? Double.isNaN(target) : Double.isNaN(x) || Double.isNaN(y)) {
            return (casts ? ".target" : Double.isNaN(x) ? ".x" : ".y") + ": found nothing, expected a number";
        }
        if (casts ? !(Double.isNaN(x) && Double.isNaN(y)) : !Double.isNaN(target)) {
            return (casts ? Double.isNaN(x) ? ".y" : ".x" : ".target") + ": found a number, expected nothing beside "
                + (casts ? "spell" : "power or throw");
        }
        return null;
    }

    private String readField(JsonParser in, String name) {
        switch (name) {
            case "x", "y" -> {
                double before = name.equals("x") ? x : y;
                double value = number(in);
                if (!(Math.abs(value) <= FARTHEST)) {
                    return name + ": found " + describe(in) + ", expected a number -1e9..1e9";
                }
                if (!Double.isNaN(before)) {
                    return name + ": found twice, expected once";
                }
                x = name.equals("x") ? value : x;
                y = name.equals("y") ? value : y;
                return null;
            }
            case "power", "throw" -> {
                Action wanted = name.equals("power") ? Action.MOVE : Action.THROW;
                power = number(in);
                if (!(power >= 0 && power <= WizardCommand.mostPower(wanted))) {
                    return name + ": found " + describe(in) + ", expected a number 0.."
                        + WizardCommand.mostPower(wanted);
                }
                return act(name, wanted);
            }
            case "spell" -> {
                String named = in.currentToken() == JsonToken.VALUE_STRING ? in.getString() : "";
                if (!SPELLS.contains(named)) {
                    return "spell: found " + describe(in) + ", expected one of " + String.join(", ", SPELLS)
                        + NearestName.question(named, SPELLS, "");
                }
                spell = Spell.valueOf(named.toUpperCase(Locale.ROOT));
                return act(name, Action.CAST);
            }
            case "target" -> {
                if (!Double.isNaN(target)) {
                    return "target: found twice, expected once";
                }
                target = number(in);
                return target == Math.rint(target) && Math.abs(target) <= MOST_ID ? null
                    : "target: found " + describe(in) + ", expected the id of an entity";
            }
            default -> {
                return TextFormat.beginning(name, 40) + ": unknown field, expected one of " + String.join(", ", FIELDS)
                    + NearestName.question(name, FIELDS, "");
            }
        }
    }

    /** A number, never -0.0; NaN if it is none. */
    private static double number(JsonParser in) {
        return in.currentToken().isNumeric() ? in.getDoubleValue() + 0.0 : Double.NaN;
    }

    private String act(String name, Action wanted) {
        if (action != null) {
            return name + ": found more than one of power, throw, spell, expected exactly one";
        }
        action = wanted;
        return null;
    }

    private static String path(int wizard) {
        return "wizards[" + wizard + "]";
    }

    private static String describe(JsonParser in) {
        JsonToken token = in.currentToken();
        if (token == null) {
            return "nothing";
        }
        return switch (token) {
            case START_OBJECT -> "an object";
            case START_ARRAY -> "an array";
            case VALUE_STRING -> "\"" + TextFormat.beginning(in.getString(), 40) + "\"";
            default -> TextFormat.beginning(in.getString(), 40);
        };
    }
}
