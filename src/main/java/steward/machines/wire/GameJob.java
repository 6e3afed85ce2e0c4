package steward.machines.wire;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import steward.match.OwnLimits;
import steward.scene.json.Block;

/**
 * Message with games for a worker to play one after the other. Short games are sent together, since a message costs as
 * much as a short game.
 *
 * @param games in order, at least one
 */
public record GameJob(String id, List<Game> games) {

    /** How many games a job may have. */
    public static final int MOST_GAMES = 32;
    private static final int MOST_SEATS = 16;
    private static final int MOST_BOTS = MOST_GAMES * MOST_SEATS;

    public GameJob {
        games = List.copyOf(games);
    }

    /**
     * One of them.
     *
     * @param seats the players in order
     */
    public record Game(long seed, List<Seat> seats) {

        public Game {
            seats = List.copyOf(seats);
        }
    }

    /**
     * A player.
     *
     * @param name   that it goes by
     * @param bundle the hash of its files
     * @param size   of those, in bytes
     * @param limits its own, or {@code null} for those of the scene
     */
    public record Seat(String name, String bundle, int size, OwnLimits limits) { }

    /** The message that says it; each bot stands there once. */
    public byte[] bytes() {
        Map<Seat, Integer> numbers = new LinkedHashMap<>();
        List<HeaderText> texts = new ArrayList<>();
        for (Game game : games) {
            List<HeaderText> seats = game.seats().stream().map(seat -> new HeaderText().put("bot",
                numbers.computeIfAbsent(seat, any -> numbers.size()))).toList();
            texts.add(new HeaderText().put("seed", Long.toString(game.seed())).put("seats", seats));
        }
        List<HeaderText> bots = numbers.keySet().stream().map(bot -> new HeaderText().put("name", bot.name())
            .put("bundle", bot.bundle()).put("size", bot.size())
            .put(OwnLimits.FIELD, OwnLimits.writtenOrNull(bot.limits()))).toList();
        return WireMessage.bytes(new HeaderText().put("type", "job").put("job", id).put("bots", bots)
            .put("games", texts));
    }

    /**
     * Reads a job.
     *
     * @param most bytes that a bundle can have
     * @throws steward.files.InputException if it is no message
     * @throws steward.scene.json.SceneException if it is no job
     */
    public static GameJob read(byte[] bytes, String source, int most) {
        Block header = WireMessage.read(bytes, source).header();
        if (!header.text("type").equals("job")) {
            throw header.error("type", header.shown("type"), "job");
        }
        String id = header.text("job");
        List<Seat> bots = new ArrayList<>();
        for (Block bot : header.blocks("bots")) {
            String bundle = bot.text("bundle");
            if (bots.size() == MOST_BOTS || !bundle.matches("[0-9a-f]{64}")) {
                throw bot.error("bundle", bot.shown("bundle"), "a hash, and at most " + MOST_BOTS + " bots");
            }
            bots.add(new Seat(bot.text("name"), bundle, bot.integer("size", 1, most), limits(bot)));
            bot.done();
        }
        List<Game> games = new ArrayList<>();
        for (Block game : header.blocks("games")) {
            if (games.size() == MOST_GAMES) {
                throw game.error("another game", "at most " + MOST_GAMES);
            }
            games.add(game(game, bots));
        }
        if (games.isEmpty()) {
            throw header.error("games", "none", "at least one");
        }
        header.done();
        return new GameJob(id, games);
    }

    private static OwnLimits limits(Block bot) {
        try {
            return bot.has(OwnLimits.FIELD) ? OwnLimits.parse(bot.text(OwnLimits.FIELD)) : null;
        } catch (IllegalArgumentException problem) {
            throw bot.error(OwnLimits.FIELD, bot.shown(OwnLimits.FIELD), OwnLimits.EXPECTED);
        }
    }

    private static Game game(Block game, List<Seat> bots) {
        long seed;
        try {
            seed = Long.parseLong(game.text("seed"));
        } catch (NumberFormatException problem) {
            throw game.error("seed", game.shown("seed"), "a whole number of 64 bits as a text");
        }
        List<Seat> seats = new ArrayList<>();
        for (Block seat : game.blocks("seats")) {
            int bot = seat.integer("bot", 0, bots.size() - 1);
            if (seats.size() == MOST_SEATS) {
                throw seat.error("another seat", "at most " + MOST_SEATS);
            }
            seats.add(bots.get(bot));
            seat.done();
        }
        game.done();
        return new Game(seed, seats);
    }
}
