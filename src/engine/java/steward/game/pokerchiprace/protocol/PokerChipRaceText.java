package steward.game.pokerchiprace.protocol;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import steward.game.CommandLines;
import steward.game.pokerchiprace.ChipCommand;
import steward.game.pokerchiprace.ChipTable;
import steward.game.pokerchiprace.PokerChipRace;
import steward.physics.Bodies;
import tools.jackson.core.io.NumberOutput;

/**
 * Line protocol of the site for the Poker Chip Race. Before the first turn a player is sent its index. A turn is the
 * number of its own chips, the number of all chips, and a line {@code id owner r x y vx vy} for each, its own first,
 * with places counted from the corner of the table. The answer is one line for each of its own chips: {@code WAIT} or
 * {@code X Y}, each with an optional message. Lines before a bad one take effect.
 */
final class PokerChipRaceText extends CommandLines {

    private static final int DECIMALS = 6;

    private static final Pattern WAIT = Pattern.compile("WAIT(?: +(.+))?", Pattern.CASE_INSENSITIVE);
    private static final Pattern PUSH = Pattern.compile("(\\S+) (\\S+)(?: +(.+))?");

    private final PokerChipRace game;

    PokerChipRaceText(PokerChipRace game) {
        super(game.players());
        this.game = game;
    }

    @Override
    public void writeSetup(StringBuilder out, int player) {
        out.append(player).append('\n');
    }

    @Override
    public void writeTurn(StringBuilder out, int player) {
        ChipTable table = game.table();
        Bodies bodies = table.bodies();
        out.append(table.owned(player)).append('\n').append(bodies.size()).append('\n');
        for (int k = 0; k < table.owned(player); k++) {
            append(out, table.ownChip(player, k));
        }
        for (int chip = 0; chip < bodies.size(); chip++) {
            if (table.owner(chip) != player) {
                append(out, chip);
            }
        }
    }

    private void append(StringBuilder out, int chip) {
        Bodies bodies = game.bodies();
        out.append(bodies.id(chip)).append(' ').append(game.ownerOf(chip));
        append(out, bodies.radius[chip]);
        append(out, bodies.x[chip] + ChipTable.HALF_WIDTH);
        append(out, bodies.y[chip] + ChipTable.HALF_HEIGHT);
        append(out, bodies.vx[chip]);
        append(out, bodies.vy[chip]);
        out.append('\n');
    }

    /** Six decimals, halves of the shortest decimal away from zero, a negative zero with its sign: as the site does. */
    private static void append(StringBuilder out, double value) {
        out.append(' ');
        if (value < 0 || value == 0 && 1 / value < 0) {
            out.append('-');
        }
        out.append(new BigDecimal(NumberOutput.toString(Math.abs(value), true))
            .setScale(DECIMALS, RoundingMode.HALF_UP).toPlainString());
    }

    @Override
    public int answerLines(int player) {
        return Math.max(1, game.table().owned(player));
    }

    /** Of a player whose chips found no place at the start, nothing is read. */
    @Override
    public String readAnswer(int player, byte[] answer, int length) {
        return game.table().owned(player) == 0 ? null : super.readAnswer(player, answer, length);
    }

    @Override
    protected String read(String line, int player, int k, List<String> said) {
        ChipCommand command = command(withoutReturn(line), game.bodies().radius[game.table().ownChip(player, k)], said);
        if (command == null) {
            return notFound("WAIT or X Y, finite numbers with one space between", withoutReturn(line));
        }
        game.command(player, k, command);
        return null;
    }

    /** The words for a small chip need not be numbers. */
    private static ChipCommand command(String line, double radius, List<String> said) {
        Matcher wait = WAIT.matcher(line);
        if (wait.matches()) {
            say(wait.group(1), said);
            return ChipCommand.WAIT;
        }
        Matcher push = PUSH.matcher(line);
        if (!push.matches()) {
            return null;
        }
        if (radius <= ChipTable.SMALL) {
            say(push.group(3), said);
            return ChipCommand.WAIT;
        }
        double x = number(push.group(1));
        double y = number(push.group(2));
        if (Double.isNaN(x) || Double.isNaN(y)) {
            return null;
        }
        say(push.group(3), said);
        return new ChipCommand(x - ChipTable.HALF_WIDTH, y - ChipTable.HALF_HEIGHT);
    }

    /** A number as Java reads it, such as {@code 1e3}, {@code 0x1p9} or {@code 3f}; NaN if it is not a finite one. */
    private static double number(String word) {
        try {
            double value = Double.parseDouble(word);
            return Double.isFinite(value) ? value : Double.NaN;
        } catch (NumberFormatException problem) {
            return Double.NaN;
        }
    }
}
