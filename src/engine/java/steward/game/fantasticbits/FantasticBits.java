package steward.game.fantasticbits;

import java.util.SortedMap;
import steward.game.AbstractGame;
import steward.game.TurnEvent;
import steward.physics.Advance;
import steward.physics.Bodies;
import steward.physics.Motion;
import steward.scene.Plan;

/**
 * Rules of Fantastic Bits in all leagues and both variants, free of JSON. Source: the published official referee; with
 * the official arithmetic, positions, speeds, scores, magic, spells and impact times agree with it to the last bit.
 *
 * <p>The game ends with the turn in which a player goes out; its score is then -1. In a faulty answer, commands before
 * the fault take effect in that turn.
 */
public final class FantasticBits extends AbstractGame {

    public static final int MOST_MAGIC = 100;

    private static final int OUT = -1;

    private final FantasticBitsSettings settings;
    private final Pitch pitch;
    private final Plan plan;
    private final Advance advance;
    private final Motion motion = new Motion(Pitch.endOfTurn());

    private static final String[] GOAL_FOR = {"goal for player 0", "goal for player 1"};

    private final WizardCommand[] commands = new WizardCommand[Pitch.WIZARDS];
    final int[] scores = new int[FantasticBitsSettings.PLAYERS];
    final int[] magic = new int[FantasticBitsSettings.PLAYERS];

    /** A game before its first turn, drawn as {@link Pitch#draw} says. */
    public FantasticBits(FantasticBitsSettings settings, Plan plan, long seed) {
        super(FantasticBitsSettings.PLAYERS);
        this.settings = settings;
        this.plan = plan;
        pitch = Pitch.draw(seed, settings.bludgers() ? Pitch.BLUDGERS : 0);
        advance = plan.advance(new Captures());
    }

    /** The other game on a pitch for the same players. */
    FantasticBits(FantasticBits other, Pitch pitch) {
        super(other);
        settings = other.settings;
        plan = other.plan;
        this.pitch = pitch;
        advance = plan.advance(new Captures());
        System.arraycopy(other.commands, 0, commands, 0, commands.length);
        System.arraycopy(other.scores, 0, scores, 0, scores.length);
        System.arraycopy(other.magic, 0, magic, 0, magic.length);
    }

    @Override
    public FantasticBits copy() {
        return new FantasticBits(this, pitch.copy());
    }

    /**
     * Returns why a wizard may not be given a command now, or {@code null}.
     *
     * @param player of the wizard
     * @param wizard 0..1, of its player
     * @return {@code null} if it may; otherwise what was found and what was expected
     */
    public String refusal(int player, int wizard, WizardCommand command) {
        int self = player * Pitch.WIZARDS_PER_PLAYER + wizard;
        if (command.action() != WizardCommand.Action.CAST) {
            int most = WizardCommand.mostPower(command.action());
            if (!(command.power() >= 0 && command.power() <= most)) {
                return "power: found " + (long) command.power() + ", expected 0.." + most;
            }
            return command.action() == WizardCommand.Action.THROW && pitch.held(self) < 0
                ? "found a throw without a snaffle in hand, expected a move or a spell" : null;
        }
        int target = command.target();
        String found = target < 0 || target >= pitch.entities() ? "no entity"
            : pitch.kind(target) == EntityKind.LOST_SNAFFLE ? "a snaffle out of play"
            : !command.spell().suits(pitch.kind(target)) ? "a " + pitch.kind(target).text()
            : pitch.kind(target) == EntityKind.WIZARD && Pitch.playerOf(target) == player ? "a wizard of the own team"
            : null;
        return found == null ? null : "target: found " + target + ", " + found + ", expected "
            + targets(command.spell());
    }

    private static String targets(Spell spell) {
        return switch (spell) {
            case OBLIVIATE -> "a bludger";
            case ACCIO -> "a bludger or a snaffle in play";
            case PETRIFICUS, FLIPENDO -> "a bludger, a snaffle in play or a wizard of the other team";
        };
    }

    /**
     * Gives a wizard a command for the next turn.
     *
     * @param wizard  0..1, of its player
     * @param command {@code null} for none; one with a {@link #refusal} does nothing
     */
    public void command(int player, int wizard, WizardCommand command) {
        commands[player * Pitch.WIZARDS_PER_PLAYER + wizard] = command;
    }

    /** The command that a wizard has for the next turn, or {@code null}. */
    public WizardCommand command(int player, int wizard) {
        return commands[player * Pitch.WIZARDS_PER_PLAYER + wizard];
    }

    @Override
    protected void playTurn() {
        pitch.beginTurn(settings.variant());
        for (int player = 0; player < players(); player++) {
            scores[player] = isIn(player) ? scores[player] : OUT;
        }
        for (int wizard = 0; wizard < Pitch.WIZARDS; wizard++) {
            obey(wizard);
        }
        int left = pitch.update();
        for (int player = 0; settings.spells() && player < players(); player++) {
            magic[player] += magic[player] < MOST_MAGIC ? 1 : 0;
        }
        advance.turn(pitch.bodies(), log);
        takeGoals();
        motion.endTurn(pitch.bodies());
        decideOutcome(left);
    }

    /** A spell that is too dear is nothing; one that is paid begins in the next turn. */
    private void obey(int wizard) {
        WizardCommand command = commands[wizard];
        commands[wizard] = null;
        int player = Pitch.playerOf(wizard);
        if (command == null || refusal(player, wizard % Pitch.WIZARDS_PER_PLAYER, command) != null) {
            return;
        }
        if (command.action() == WizardCommand.Action.CAST) {
            int cost = settings.variant().cost(command.spell());
            if (magic[player] >= cost) {
                magic[player] -= cost;
                pitch.spells().cast(wizard, command.spell(), command.target());
            }
        }
        pitch.obey(wizard, command);
    }

    private void takeGoals() {
        for (int k = 0; k < log.facts(); k++) {
            if (log.factKind(k) == Captures.GOAL) {
                int player = log.factB(k);
                scores[player] += isIn(player) ? 1 : 0;
                events.add(TurnEvent.Kind.DEATH, log.factTime(k), log.factA(k), log.factX(k), log.factY(k),
                    GOAL_FOR[player], true);
            }
        }
    }

    private void decideOutcome(int left) {
        if (!isIn(0) || !isIn(1)) {
            end(isIn(0) || isIn(1) ? "a player is out" : "both players are out");
        } else if (Math.max(scores[0], scores[1]) >= winningScore()) {
            end("a score of " + winningScore() + " of " + pitch.snaffles() + " is reached");
        } else if (left == 0) {
            end("no snaffle was left");
        } else if (turn() >= settings.maximumTurns()) {
            end("at most " + settings.maximumTurns() + " turns are played");
        }
    }

    /** The score that ends the game: more than half of the snaffles. */
    public int winningScore() {
        return pitch.snaffles() / 2 + 1;
    }

    /** By score; that of a player who is out is -1. */
    @Override
    public int[] ranks() {
        return ranks((one, other) -> standing(one) > standing(other));
    }

    /** The goals; -1 for a player who is out. */
    @Override
    public double[] scores() {
        return new double[] {standing(0), standing(1)};
    }

    /** Goals, also of a player who is out. */
    @Override
    public SortedMap<String, double[]> ownValues() {
        return ownValue("goals", player -> scores[player]);
    }

    private int standing(int player) {
        return isIn(player) ? scores[player] : OUT;
    }

    public FantasticBitsSettings settings() {
        return settings;
    }

    /** The goals of a player; -1 once it has been out for a turn. */
    public int score(int player) {
        return scores[player];
    }

    /** The magic of a player, 0..{@value #MOST_MAGIC}. */
    public int magic(int player) {
        return magic[player];
    }

    /** Wizards, snaffles, bludgers, posts and spells. */
    public Pitch pitch() {
        return pitch;
    }

    @Override
    public Bodies bodies() {
        return pitch.bodies();
    }

    /** Order: turn; per player score, magic, whether in; the pitch. */
    @Override
    public long hash() {
        hash.reset().add(turn());
        for (int player = 0; player < players(); player++) {
            hash.add(scores[player]).add(magic[player]).add(isIn(player));
        }
        pitch.addTo(hash);
        return hash.value();
    }
}
