package steward.game.meanmax;

import java.util.List;
import java.util.SortedMap;
import steward.game.AbstractGame;
import steward.game.TurnEvent;
import steward.physics.Advance;
import steward.physics.Bodies;
import steward.scene.Plan;

/**
 * Rules of Mean Max in all leagues, free of JSON. Source: the published official referee; with the official arithmetic,
 * positions, speeds, masses, scores, rages, ids and impact times agree with it to the last bit.
 *
 * <p>The units of a player who is out drift on, may harvest, and its tankers keep coming; its score stays. In a faulty
 * answer, commands before the fault take effect in that turn.
 */
public final class MeanMax extends AbstractGame {

    public static final int MOST_RAGE = 300;

    private static final double RAGE_BY_SPEED = 0.01;
    private static final int REAPER = UnitKind.REAPER.ordinal();
    private static final int DOOF = UnitKind.DOOF.ordinal();

    private final MeanMaxSettings settings;
    private final MeanMaxWorld world;
    private final Plan plan;
    private final Advance advance;
    private final OilMotion motion = new OilMotion();

    private static final String[] SUNK_BY = {"sunk by player 0", "sunk by player 1", "sunk by player 2"};

    private final LooterCommand[] commands = new LooterCommand[MeanMaxSettings.PLAYERS * UnitKind.LOOTERS];
    final int[] scores = new int[MeanMaxSettings.PLAYERS];
    final int[] rages = new int[MeanMaxSettings.PLAYERS];
    private final int[] leaving;

    /** A game before its first turn, drawn as {@link MeanMaxWorld#draw} says. */
    public MeanMax(MeanMaxSettings settings, Plan plan, long seed) {
        super(MeanMaxSettings.PLAYERS);
        this.settings = settings;
        this.plan = plan;
        world = MeanMaxWorld.draw(settings, seed, MeanMaxSettings.PLAYERS);
        advance = plan.advance(new Sinking());
        leaving = new int[world.bodies().capacity()];
        motion.endTurn(world.bodies(), world);
    }

    /** The other game in a world for the same players. */
    MeanMax(MeanMax other, MeanMaxWorld world) {
        super(other);
        settings = other.settings;
        plan = other.plan;
        this.world = world;
        advance = plan.advance(new Sinking());
        leaving = new int[world.bodies().capacity()];
        System.arraycopy(other.commands, 0, commands, 0, commands.length);
        System.arraycopy(other.scores, 0, scores, 0, scores.length);
        System.arraycopy(other.rages, 0, rages, 0, rages.length);
    }

    @Override
    public MeanMax copy() {
        return new MeanMax(this, world.copy());
    }

    /**
     * Gives a looter a command for the next turn; a looter that the league does not have does nothing.
     *
     * @param looter  0..2
     * @param command {@code null} for none
     */
    public void command(int player, int looter, LooterCommand command) {
        commands[player * UnitKind.LOOTERS + looter] = command;
    }

    /** The command that a looter has for the next turn, or {@code null}. */
    public LooterCommand command(int player, int looter) {
        return commands[player * UnitKind.LOOTERS + looter];
    }

    @Override
    protected void playTurn() {
        for (int command = 0; command < commands.length; command++) {
            castSkill(command);
        }
        world.applyEffects();
        world.steerTankers();
        thrustLooters();
        advance.turn(world.bodies(), log);
        takeFacts();
        replaceTankers();
        harvest();
        motion.endTurn(world.bodies(), world);
        if (settings.looters() > DOOF) {
            sing();
        }
        world.restoreMasses();
        world.removeSpentEffects();
        decideOutcome();
    }

    /** The songs of doofs give rage. */
    private void sing() {
        for (int player = 0; player < players(); player++) {
            int doof = world.looter(player, DOOF);
            double vx = world.bodies().vx[doof];
            double vy = world.bodies().vy[doof];
            rages[player] = Math.min(MOST_RAGE,
                rages[player] + (int) Math.floor(Math.sqrt(vx * vx + vy * vy) * RAGE_BY_SPEED));
        }
    }

    /** A skill that the league does not have, that is too dear or too far away is nothing. */
    private void castSkill(int number) {
        LooterCommand command = commands[number];
        if (command == null || command.action() != LooterCommand.Action.SKILL) {
            return;
        }
        int player = number / UnitKind.LOOTERS;
        int kind = number % UnitKind.LOOTERS;
        int looter = world.looter(player, kind);
        Skill skill = UnitKind.of(kind).skill();
        if (settings.isActive(skill) && rages[player] >= skill.cost()
            && world.distance(looter, command.x(), command.y()) <= MeanMaxWorld.SKILL_RANGE) {
            rages[player] -= skill.cost();
            world.cast(skill, command.x(), command.y(), looter);
        }
    }

    private void thrustLooters() {
        for (int number = 0; number < commands.length; number++) {
            LooterCommand command = commands[number];
            int kind = number % UnitKind.LOOTERS;
            if (command != null && command.action() == LooterCommand.Action.MOVE && kind < settings.looters()) {
                world.thrust(world.looter(number / UnitKind.LOOTERS, kind), command.x(), command.y(),
                    Math.min(LooterCommand.MOST_POWER, command.power()));
            }
            commands[number] = null;
        }
    }

    /** Sunken tankers: their wrecks come to be. */
    private void takeFacts() {
        for (int k = 0; k < log.facts(); k++) {
            if (log.factKind(k) == Sinking.WRECK) {
                world.addWreck(log.factB(k), log.factX(k), log.factY(k), log.factQ(k), (int) log.factP(k), -1);
            } else {
                events.add(TurnEvent.Kind.DEATH, log.factTime(k), log.factA(k), log.factX(k), log.factY(k),
                    SUNK_BY[playerOf(log.factB(k))], false);
            }
        }
    }

    /** Tankers fill and leave; for each that is gone, those sunk first, a new one comes. */
    private void replaceTankers() {
        Bodies bodies = world.bodies();
        int count = world.fillTankers(leaving);
        for (int k = 0; k < count; k++) {
            int tanker = leaving[k];
            leaving[k] = (int) bodies.columns[MeanMaxWorld.OWNER][tanker];
            events.add(TurnEvent.Kind.DEATH, 1, bodies.id(tanker), bodies.x[tanker], bodies.y[tanker], "left full",
                false);
        }
        for (int k = events.size() - 1, left = count; left > 0; k--, left--) {
            bodies.remove(bodies.indexOf(events.body(k)));
        }
        for (int k = 0; k < log.facts(); k++) {
            if (log.factKind(k) == Sinking.SUNK) {
                spawn((int) log.factP(k));
            }
        }
        for (int k = 0; k < count; k++) {
            spawn(leaving[k]);
        }
    }

    private void spawn(int player) {
        int tanker = world.spawn(player);
        if (tanker >= 0) {
            events.add(TurnEvent.Kind.BIRTH, 1, world.bodies().id(tanker), world.bodies().x[tanker],
                world.bodies().y[tanker], "", false);
        }
    }

    /** Every reaper in a wreck takes one water, also where less is left; but not in oil. */
    private void harvest() {
        List<Wreck> wrecks = world.wrecks();
        for (int k = 0; k < wrecks.size(); k++) {
            Wreck wreck = wrecks.get(k);
            for (int player = 0; player < players(); player++) {
                int reaper = world.looter(player, REAPER);
                if (world.distance(reaper, wreck.x(), wreck.y()) <= wreck.radius() && !world.isInOil(reaper)) {
                    scores[player]++;
                    wreck.takeWater();
                }
            }
        }
        if (settings.hasWrecksOnly()) {
            replaceWrecks(wrecks.size());
        }
        for (int k = wrecks.size() - 1; k >= 0; k--) {
            if (wrecks.get(k).water() <= 0) {
                world.removeWreck(k);
            }
        }
    }

    /** Others come for the first wrecks that are empty, in the order of the published referee's hash table. */
    private void replaceWrecks(int count) {
        for (int bucket = 0; bucket < Wreck.BUCKETS; bucket++) {
            for (int k = 0; k < count; k++) {
                Wreck wreck = world.wrecks().get(k);
                if (wreck.water() <= 0 && wreck.bucket() == bucket) {
                    spawn(wreck.player());
                }
            }
        }
    }

    private void decideOutcome() {
        int in = 0;
        int last = -1;
        int best = 0;
        for (int player = 0; player < players(); player++) {
            if (isIn(player)) {
                in++;
                last = player;
            }
            best = Math.max(best, scores[player]);
        }
        if (best >= settings.winningScore()) {
            end("a score of " + settings.winningScore() + " is reached");
        } else if (in == 0) {
            end("all are out");
        } else if (in == 1 && isAhead(last)) {
            end("all others are out and behind");
        } else if (turn() >= settings.maximumTurns()) {
            end("at most " + settings.maximumTurns() + " turns are played");
        }
    }

    private boolean isAhead(int player) {
        for (int other = 0; other < players(); other++) {
            if (other != player && scores[other] >= scores[player]) {
                return false;
            }
        }
        return true;
    }

    /** By score; a player who is out keeps its own. */
    @Override
    public int[] ranks() {
        return ranks((one, other) -> scores[one] > scores[other]);
    }

    /** The water harvested. */
    @Override
    public double[] scores() {
        double[] of = new double[players()];
        for (int player = 0; player < players(); player++) {
            of[player] = scores[player];
        }
        return of;
    }

    /** Water that was collected. */
    @Override
    public SortedMap<String, double[]> ownValues() {
        return ownValue("water", player -> scores[player]);
    }

    public MeanMaxSettings settings() {
        return settings;
    }

    /** The water that a player has harvested. */
    public int score(int player) {
        return scores[player];
    }

    /** The rage of a player, 0..{@value #MOST_RAGE}. */
    public int rage(int player) {
        return rages[player];
    }

    /** Looters, tankers, wrecks and effects. */
    public MeanMaxWorld world() {
        return world;
    }

    /** The player of a body, or -1 for a tanker. */
    public int playerOf(int id) {
        return id < players() * settings.looters() ? id / settings.looters() : -1;
    }

    @Override
    public Bodies bodies() {
        return world.bodies();
    }

    /** Order: turn; per player score, rage, whether in; the world. */
    @Override
    public long hash() {
        hash.reset().add(turn());
        for (int player = 0; player < players(); player++) {
            hash.add(scores[player]).add(rages[player]).add(isIn(player));
        }
        world.addTo(hash);
        return hash.value();
    }
}
