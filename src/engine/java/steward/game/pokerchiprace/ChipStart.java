package steward.game.pokerchiprace;

import java.util.ArrayList;
import java.util.List;
import steward.numerics.JavaRandom;
import steward.numerics.SineCosine;

/**
 * Start of a Poker Chip Race, drawn with Java's generator as the published referee does. First it draws the most
 * neutral chips, and number and radius of each player's chips; then places, until all chips of the players have one.
 */
final class ChipStart {

    private static final int MOST_NEUTRAL = 50;
    private static final int MOST_PER_PLAYER = 5;
    private static final double LEAST_RADIUS = 17.5;
    private static final double LEAST_NEUTRAL_RADIUS = 10;
    private static final double GREATEST_RADIUS = 25;
    private static final double GREATEST_SPEED = 10;
    private static final int ATTEMPTS = 21;
    private static final int PLACES = 50;
    /** How many times the sum of the radii a new chip keeps away from a player's chip, and from a neutral one. */
    private static final double PLAYER_DISTANCE = 2;
    private static final double NEUTRAL_DISTANCE = 1.4;

    private final JavaRandom random;
    private final int players;
    private final boolean symmetric;
    private final int neutral;
    private final int perPlayer;
    private final double playerRadius;
    private final SineCosine direction = new SineCosine();

    /** Chips so far: owner, radius, x, y, vx, vy. */
    private final List<double[]> chips = new ArrayList<>();
    private int thrownAway;
    private double placeX;
    private double placeY;

    private ChipStart(PokerChipRaceSettings settings, long seed) {
        random = new JavaRandom(seed);
        players = settings.players();
        symmetric = settings.symmetric();
        int drawnNeutral = players + random.nextInt(MOST_NEUTRAL - players);
        int drawnPerPlayer = random.nextInt(MOST_PER_PLAYER) + 1;
        double drawnRadius = Math.floor(random.nextDouble() * (GREATEST_RADIUS - LEAST_RADIUS) + LEAST_RADIUS + 0.5);
        neutral = settings.neutral() == PokerChipRaceSettings.DRAWN ? drawnNeutral : settings.neutral();
        perPlayer = settings.perPlayer() == PokerChipRaceSettings.DRAWN ? drawnPerPlayer : settings.perPlayer();
        playerRadius = Double.isNaN(settings.radius()) ? drawnRadius : settings.radius();
    }

    /**
     * A table before the first turn, with room for all chips that can be ejected in a game. If no attempt finds a place
     * for every chip of the players, the game begins with the chips that the last one has placed.
     */
    static ChipTable draw(PokerChipRaceSettings settings, long seed) {
        ChipStart start = new ChipStart(settings, seed);
        boolean placed = false;
        for (int attempt = 0; attempt < ATTEMPTS && !placed; attempt++) {
            start.thrownAway += start.chips.size();
            start.chips.clear();
            placed = start.symmetric ? start.placeSymmetric() : start.placeAnywhere();
        }
        int own = (int) start.chips.stream().filter(chip -> chip[0] != ChipTable.NEUTRAL).count();
        ChipTable table = new ChipTable(start.players, start.chips.size() + own * settings.maximumTurns() + 1);
        table.takeIdsUpTo(start.thrownAway);
        for (double[] chip : start.chips) {
            table.add((int) chip[0], chip[1], chip[2], chip[3], chip[4], chip[5]);
        }
        return table;
    }

    /** @return whether every chip of the players has a place */
    private boolean placeAnywhere() {
        for (int player = 0; player < players; player++) {
            for (int k = 0; k < perPlayer; k++) {
                if (!findPlace(playerRadius)) {
                    return false;
                }
                add(player, playerRadius, placeX, placeY, 0, 0);
            }
        }
        for (int i = neutral - 1; i >= 0; i--) {
            double radius = neutralRadius();
            if (!findPlace(radius)) {
                return true;
            }
            double speed = neutralSpeed(radius);
            direction.turn(random.nextDouble() * Math.PI);
            add(ChipTable.NEUTRAL, radius, placeX, placeY, direction.cos() * speed, direction.sin() * speed);
        }
        return true;
    }

    /** @return whether every chip of the players has a place */
    private boolean placeSymmetric() {
        if (players % 2 == 1) {
            int third = players - 1;
            if (perPlayer % 2 == 1) {
                add(third, playerRadius, 0, 0, 0, 0);
            }
            for (int k = 0; k < perPlayer / 2; k++) {
                if (!findPlace(playerRadius)) {
                    return false;
                }
                add(third, playerRadius, placeX, placeY, 0, 0);
                add(third, playerRadius, 0 - placeX, 0 - placeY, 0, 0);
            }
        }
        boolean four = players == PokerChipRaceSettings.MOST_PLAYERS;
        for (int k = 0; k < perPlayer; k++) {
            if (!findPlace(playerRadius)) {
                return false;
            }
            add(0, playerRadius, placeX, placeY, 0, 0);
            add(1, playerRadius, 0 - placeX, 0 - placeY, 0, 0);
            if (four) {
                add(2, playerRadius, placeX, 0 - placeY, 0, 0);
                add(3, playerRadius, 0 - placeX, placeY, 0, 0);
            }
        }
        for (int i = neutral - 1; i >= 0; i -= players - players % 2) {
            double radius = neutralRadius();
            if (!findPlace(radius)) {
                return true;
            }
            double speed = neutralSpeed(radius);
            direction.turn(random.nextDouble() * Math.PI);
            double vx = direction.cos() * speed;
            double vy = direction.sin() * speed;
            add(ChipTable.NEUTRAL, radius, placeX, placeY, vx, vy);
            add(ChipTable.NEUTRAL, radius, 0 - placeX, 0 - placeY, vx * -1, vy * -1);
            if (four) {
                add(ChipTable.NEUTRAL, radius, placeX, 0 - placeY, vx, vy * -1);
                add(ChipTable.NEUTRAL, radius, 0 - placeX, placeY, vx * -1, vy);
            }
        }
        return true;
    }

    private double neutralRadius() {
        return random.nextDouble() * (GREATEST_RADIUS - LEAST_NEUTRAL_RADIUS) + LEAST_NEUTRAL_RADIUS;
    }

    /** A neutral chip is at rest unless it is smaller than those of the players. */
    private double neutralSpeed(double radius) {
        double speed = random.nextDouble() * GREATEST_SPEED;
        return radius >= playerRadius ? 0 : speed;
    }

    /** Draws places until one is free. @return false if none of them is */
    private boolean findPlace(double radius) {
        for (int drawn = 0; drawn < PLACES; drawn++) {
            placeX = -ChipTable.HALF_WIDTH + radius + random.nextDouble() * (2 * ChipTable.HALF_WIDTH - radius * 2);
            placeY = -ChipTable.HALF_HEIGHT + radius + random.nextDouble() * (2 * ChipTable.HALF_HEIGHT - radius * 2);
            if (!isBlocked(radius)) {
                return true;
            }
        }
        return false;
    }

    private boolean isBlocked(double radius) {
        if (placeX - radius < -ChipTable.HALF_WIDTH || placeX + radius > ChipTable.HALF_WIDTH
            || placeY - radius < -ChipTable.HALF_HEIGHT || placeY + radius > ChipTable.HALF_HEIGHT
            || symmetric && (Math.abs(placeX) <= 2 * radius || Math.abs(placeY) <= 2 * radius)) {
            return true;
        }
        for (double[] chip : chips) {
            double dx = placeX - chip[2];
            double dy = placeY - chip[3];
            double factor = chip[0] == ChipTable.NEUTRAL ? NEUTRAL_DISTANCE : PLAYER_DISTANCE;
            if (Math.sqrt(dx * dx + dy * dy) <= (radius + chip[1]) * factor) {
                return true;
            }
        }
        return false;
    }

    private void add(int owner, double radius, double x, double y, double vx, double vy) {
        chips.add(new double[] {owner, radius, x, y, vx, vy});
    }
}
