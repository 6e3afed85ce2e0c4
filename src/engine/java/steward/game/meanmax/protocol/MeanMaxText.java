package steward.game.meanmax.protocol;

import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import steward.game.CommandLines;
import steward.game.meanmax.LooterCommand;
import steward.game.meanmax.MeanMax;
import steward.game.meanmax.MeanMaxWorld;
import steward.game.meanmax.SkillEffect;
import steward.game.meanmax.UnitKind;
import steward.game.meanmax.Wreck;
import steward.physics.Bodies;
import steward.physics.Motion;

/**
 * Line protocol of the site for Mean Max. A turn is the scores and rages, the reader's own first, the number of units,
 * and a line {@code id type player mass radius x y vx vy extra extra2} for each unit, wreck and skill effect; there is
 * no setup. The answer is three lines, for reaper, destroyer and doof: {@code X Y POWER}, {@code SKILL X Y} or {@code
 * WAIT}, each with an optional message. Lines before a bad one take effect; lines for looters that the league does not
 * have are not read.
 */
final class MeanMaxText extends CommandLines {

    private static final int WRECK_TYPE = 4;

    private static final Pattern WAIT = Pattern.compile("WAIT(?:\\s+(.+))?", Pattern.CASE_INSENSITIVE);
    private static final Pattern MOVE =
        Pattern.compile("(-?[0-9]{1,9})\\s+(-?[0-9]{1,9})\\s+([0-9]{1,9})(?:\\s+(.+))?");
    private static final Pattern SKILL =
        Pattern.compile("SKILL\\s+(-?[0-9]{1,9})\\s+(-?[0-9]{1,9})(?:\\s+(.+))?", Pattern.CASE_INSENSITIVE);

    private final MeanMax game;

    MeanMaxText(MeanMax game) {
        super(game.players());
        this.game = game;
    }

    @Override
    public void writeSetup(StringBuilder out, int player) {
        // There is none.
    }

    @Override
    public void writeTurn(StringBuilder out, int player) {
        for (int k = 0; k < game.players(); k++) {
            out.append(game.score(shown(player, k))).append('\n');
        }
        for (int k = 0; k < game.players(); k++) {
            out.append(game.rage(shown(player, k))).append('\n');
        }
        MeanMaxWorld world = game.world();
        Bodies bodies = world.bodies();
        out.append(bodies.size() + world.wrecks().size() + world.effects().size()).append('\n');
        for (int unit = 0; unit < bodies.size(); unit++) {
            boolean tanker = world.isTanker(unit);
            int owner = (int) bodies.columns[MeanMaxWorld.OWNER][unit];
            out.append(bodies.id(unit)).append(' ').append(bodies.kind[unit]).append(' ')
                .append(tanker ? -1 : number(player, owner)).append(' ').append(bodies.mass[unit]).append(' ');
            append(out, bodies.radius[unit]);
            append(out, bodies.x[unit]);
            append(out, bodies.y[unit]);
            append(out, bodies.vx[unit]);
            append(out, bodies.vy[unit]);
            out.append(tanker ? (int) bodies.columns[MeanMaxWorld.WATER][unit] : -1).append(' ')
                .append(tanker ? (int) bodies.columns[MeanMaxWorld.SIZE][unit] : -1).append('\n');
        }
        for (Wreck wreck : world.wrecks()) {
            place(out, wreck.id(), WRECK_TYPE, wreck.radius(), wreck.x(), wreck.y(), wreck.water());
        }
        for (SkillEffect effect : world.effects()) {
            place(out, effect.id(), effect.skill().type(), MeanMaxWorld.SKILL_RADIUS, effect.x(), effect.y(),
                effect.duration());
        }
    }

    /** The player that stands k-th for a reader: the reader first, then the others in their order. */
    private static int shown(int reader, int k) {
        return k == 0 ? reader : k <= reader ? k - 1 : k;
    }

    /** The number of a player for a reader, the inverse of {@link #shown}. */
    private static int number(int reader, int player) {
        return player == reader ? 0 : player < reader ? player + 1 : player;
    }

    private static void append(StringBuilder out, double value) {
        out.append((long) Motion.roundHalfAway(value)).append(' ');
    }

    private static void place(StringBuilder out, int id, int type, double radius, double x, double y, int extra) {
        out.append(id).append(' ').append(type).append(" -1 -1 ");
        append(out, radius);
        append(out, x);
        append(out, y);
        out.append("0 0 ").append(extra).append(" -1\n");
    }

    @Override
    public int answerLines(int player) {
        return UnitKind.LOOTERS;
    }

    @Override
    protected String read(String line, int player, int looter, List<String> said) {
        LooterCommand command = command(withoutReturn(line), looter, said);
        if (command == null) {
            return notFound("X Y POWER, SKILL X Y or WAIT, whole numbers of at most 9 digits", withoutReturn(line));
        }
        game.command(player, looter, command);
        return null;
    }

    private LooterCommand command(String line, int index, List<String> said) {
        if (index >= game.settings().looters()) {
            return LooterCommand.WAIT;                  // in lower leagues the lines of the others are passed over
        }
        Matcher wait = WAIT.matcher(line);
        if (wait.matches()) {
            say(wait.group(1), said);
            return LooterCommand.WAIT;
        }
        Matcher move = MOVE.matcher(line);
        if (move.matches()) {
            say(move.group(4), said);
            return LooterCommand.move(Integer.parseInt(move.group(1)), Integer.parseInt(move.group(2)),
                Math.min(LooterCommand.MOST_POWER, Integer.parseInt(move.group(3))));
        }
        Matcher skill = SKILL.matcher(line);
        if (skill.matches()) {
            say(skill.group(3), said);
            return LooterCommand.skill(Integer.parseInt(skill.group(1)), Integer.parseInt(skill.group(2)));
        }
        return null;
    }
}
