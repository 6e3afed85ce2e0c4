package steward.game.pokerchiprace;

import java.util.Arrays;
import java.util.SortedMap;
import steward.game.AbstractGame;
import steward.game.TurnEvent;
import steward.numerics.StrictAngles;
import steward.physics.Advance;
import steward.physics.Bodies;
import steward.scene.Plan;

/**
 * Rules of the Poker Chip Race, free of JSON. Source: the published official referee; with the official arithmetic,
 * positions, speeds, radii, ids, scores and impact times agree with it to the last bit.
 *
 * <p>The chips of a player who is out become neutral. In a faulty answer, pushes before the fault take effect in that
 * turn. With fewer than two players left the game ends without playing the turn. New chips take their ids in the order
 * of players and of their lines.
 */
public final class PokerChipRace extends AbstractGame {

    /** A chip that is pushed toward a place nearer than this, in u, stays as it is. */
    private static final double LEAST_DISTANCE = 0.5;
    private static final double NOT_LOST = -1;
    private static final String[] EATEN_BY = {"eaten by player 0", "eaten by player 1", "eaten by player 2",
        "eaten by player 3"};

    private final PokerChipRaceSettings settings;
    private final Plan plan;
    private final ChipTable table;
    private final Advance advance;
    private final Ranking ranking;
    private final ChipCommand[][] commands;
    final double[] lost;
    private final double[] lastEaten;
    private int[] pushed = new int[8];
    private double[] angles = new double[8];

    /** A game before its first turn, drawn as {@link ChipStart} says. */
    public PokerChipRace(PokerChipRaceSettings settings, Plan plan, long seed) {
        this(settings, plan, ChipStart.draw(settings, seed));
    }

    /** A game before its first turn, with chips for the players of its settings. */
    PokerChipRace(PokerChipRaceSettings settings, Plan plan, ChipTable table) {
        super(settings.players());
        this.settings = settings;
        this.plan = plan;
        this.table = table;
        advance = plan.advance(new ChipEating());
        ranking = new Ranking(players());
        commands = new ChipCommand[players()][];
        lost = new double[players()];
        lastEaten = new double[players()];
        Arrays.fill(lost, NOT_LOST);
        for (int player = 0; player < players(); player++) {
            commands[player] = new ChipCommand[table.owned(player)];
        }
        ranking.set(table, lost);
    }

    private PokerChipRace(PokerChipRace other) {
        super(other);
        settings = other.settings;
        plan = other.plan;
        table = other.table.copy();
        advance = plan.advance(new ChipEating());
        ranking = new Ranking(players());
        commands = new ChipCommand[players()][];
        for (int player = 0; player < players(); player++) {
            commands[player] = other.commands[player].clone();
        }
        lost = other.lost.clone();
        lastEaten = new double[players()];
        ranking.copy(other.ranking);
    }

    @Override
    public PokerChipRace copy() {
        return new PokerChipRace(this);
    }

    /**
     * Gives a chip a command for the next turn.
     *
     * @param chip    its place in the list of its player's chips, 0 for the first
     * @param command {@code null} for none
     */
    public void command(int player, int chip, ChipCommand command) {
        commands[player][chip] = command;
    }

    /** The command that a chip has for the next turn, or {@code null}. */
    public ChipCommand command(int player, int chip) {
        return commands[player][chip];
    }

    @Override
    public int fewestPlayers() {
        return PokerChipRaceSettings.FEWEST_PLAYERS;
    }

    @Override
    protected void playTurn() {
        table.forgetParents();
        int pushes = takePushes();
        int in = 0;
        for (int player = 0; player < players(); player++) {
            if (!isIn(player) && lost[player] < 0) {
                lost[player] = turn() - 1;
                table.abandon(player);
            }
            in += isIn(player) ? 1 : 0;
        }
        if (in < fewestPlayers()) {
            ranking.set(table, lost);
            end(ending(in) + ", the turn is not played");
            return;
        }
        for (int k = 0; k < pushes; k++) {
            int part = table.push(pushed[k], angles[k], log);
            events.add(TurnEvent.Kind.BIRTH, 0, bodies().id(part), bodies().x[part], bodies().y[part], "", false);
        }
        advance.turn(table.bodies(), log);
        takeFacts();
        takeDeaths();
        ranking.set(table, lost);
        table.forgetEaten();
        decideOutcome();
    }

    /** Players in order, and their chips in the order of their lists. @return how many there are */
    private int takePushes() {
        int count = 0;
        for (int player = 0; player < players(); player++) {
            for (int k = 0; k < table.owned(player); k++) {
                ChipCommand command = commands[player][k];
                commands[player][k] = null;
                int chip = table.ownChip(player, k);
                if (command == null || command.waits() || bodies().radius[chip] <= ChipTable.SMALL) {
                    continue;
                }
                double dx = command.x() - bodies().x[chip];
                double dy = command.y() - bodies().y[chip];
                if (Math.sqrt(dy * dy + dx * dx) < LEAST_DISTANCE) {
                    continue;
                }
                if (count == pushed.length) {
                    pushed = Arrays.copyOf(pushed, 2 * count);
                    angles = Arrays.copyOf(angles, 2 * count);
                }
                pushed[count] = bodies().id(chip);
                angles[count++] = StrictAngles.atan2(dy, dx);
            }
        }
        return count;
    }

    private void takeFacts() {
        Arrays.fill(lastEaten, 0);
        for (int k = 0; k < log.facts(); k++) {
            if (log.factKind(k) == ChipEating.EATEN) {
                int owner = (int) log.factP(k);
                if (owner != ChipTable.NEUTRAL) {
                    lastEaten[owner] = Math.max(lastEaten[owner], log.factTime(k));
                }
                events.add(TurnEvent.Kind.DEATH, log.factTime(k), log.factA(k), log.factX(k), log.factY(k),
                    owner == ChipTable.NEUTRAL ? "" : eatenBy(log.factB(k)), false);
            }
        }
    }

    private String eatenBy(int id) {
        int chip = bodies().indexOf(id);
        int owner = chip < 0 ? ChipTable.NEUTRAL : table.owner(chip);
        return owner == ChipTable.NEUTRAL ? "eaten" : EATEN_BY[owner];
    }

    private void takeDeaths() {
        for (int player = 0; player < players(); player++) {
            if (lost[player] < 0 && table.isWithoutChips(player)) {
                lost[player] = turn() + lastEaten[player];
                putOut(player, table.owned(player) == 0 ? "it has no chips" : "its last chip was eaten");
            }
        }
    }

    private void decideOutcome() {
        int in = 0;
        for (int player = 0; player < players(); player++) {
            in += isIn(player) ? 1 : 0;
        }
        if (in < fewestPlayers()) {
            end(ending(in));
        } else if (turn() >= settings.maximumTurns()) {
            end("at most " + settings.maximumTurns() + " turns are played");
        }
    }

    private static String ending(int in) {
        return in == 0 ? "all are out" : "all others are out";
    }

    /** By score. */
    @Override
    public int[] ranks() {
        return ranks((one, other) -> ranking.score(one) > ranking.score(other));
    }

    /**
     * Returns the scores as the published referee counts them: the area of the chips, in u^2, and the rank among the
     * players.
     */
    @Override
    public double[] scores() {
        double[] of = new double[players()];
        for (int player = 0; player < players(); player++) {
            of[player] = ranking.score(player);
        }
        return of;
    }

    /** Chips that are left. */
    @Override
    public SortedMap<String, double[]> ownValues() {
        return ownValue("chips", player -> table().owned(player));
    }

    public int score(int player) {
        return ranking.score(player);
    }

    /** Returns when a player has lost its last chip: the turn and the time within it; below 0 while it has one. */
    public double lost(int player) {
        return lost[player];
    }

    /**
     * The owner of a chip as players see it, or {@link ChipTable#NEUTRAL}: the chips of a player who has failed in this
     * turn are neutral for those who are asked after it.
     */
    public int ownerOf(int chip) {
        int owner = table.owner(chip);
        return owner == ChipTable.NEUTRAL || isIn(owner) ? owner : ChipTable.NEUTRAL;
    }

    public PokerChipRaceSettings settings() {
        return settings;
    }

    /** The chips, and who owns which. */
    public ChipTable table() {
        return table;
    }

    @Override
    public Bodies bodies() {
        return table.bodies();
    }

    /** Order: turn; per player whether in and when it has lost; the table. */
    @Override
    public long hash() {
        hash.reset().add(turn());
        for (int player = 0; player < players(); player++) {
            hash.add(isIn(player)).add(lost[player]);
        }
        table.addTo(hash);
        return hash.value();
    }
}
