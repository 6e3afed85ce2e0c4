package steward.machines.wire;

import java.util.ArrayList;
import java.util.List;
import steward.scene.json.Block;

/**
 * A game that a worker is to play.
 *
 * @param id    of the job
 * @param seed  of the game
 * @param seats the players in order
 */
public record GameJob(String id, long seed, List<Seat> seats) {

    private static final int MOST_SEATS = 16;

    /** Copies the list. */
    public GameJob {
        seats = List.copyOf(seats);
    }

    /**
     * A player.
     *
     * @param name   that it goes by
     * @param bundle the hash of its files
     * @param size   of those, in bytes
     */
    public record Seat(String name, String bundle, int size) {
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
        long seed;
        try {
            seed = Long.parseLong(header.text("seed"));
        } catch (NumberFormatException problem) {
            throw header.error("seed", header.shown("seed"), "a whole number of 64 bits as a text");
        }
        List<Seat> seats = new ArrayList<>();
        for (Block seat : header.blocks("seats")) {
            String bundle = seat.text("bundle");
            if (seats.size() == MOST_SEATS || !bundle.matches("[0-9a-f]{64}")) {
                throw seat.error("bundle", seat.shown("bundle"), "a hash, and at most " + MOST_SEATS + " seats");
            }
            seats.add(new Seat(seat.text("name"), bundle, seat.integer("size", 1, most)));
            seat.done();
        }
        header.done();
        return new GameJob(id, seed, seats);
    }
}
