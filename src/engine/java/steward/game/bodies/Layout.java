package steward.game.bodies;

import java.util.ArrayList;
import java.util.List;
import steward.numerics.SplitMix64;
import steward.scene.Bumper;
import steward.scene.Field;

/**
 * Layout of a scene's discs: listed ones, which {@link #check} tests, and those of fills, which the seed draws into
 * free room.
 *
 * @param field  its walls and bumpers are where no disc can be
 * @param listed in their order
 * @param fills  in their order
 */
public record Layout(Field field, List<Body> listed, List<Fill> fills) {

    public Layout {
        listed = List.copyOf(listed);
        fills = List.copyOf(fills);
    }

    /** A fill for which there is not enough room. */
    public static final class NoRoomException extends RuntimeException {

        private final int fill;
        private final int placed;

        private NoRoomException(int fill, int placed) {
            super("room for " + placed);
            this.fill = fill;
            this.placed = placed;
        }

        public int fill() {
            return fill;
        }

        /** Number of discs that there was room for. */
        public int placed() {
            return placed;
        }
    }

    /** Returns the number of all discs, bumpers left out. */
    public int count() {
        return listed.size() + fills.stream().mapToInt(Fill::count).sum();
    }

    /**
     * Returns all discs. Listed ones are taken as they are.
     *
     * @param seed of the match
     * @throws NoRoomException if a fill does not fit
     */
    public List<Body> draw(long seed) {
        List<Body> bodies = new ArrayList<>(listed);
        if (fills.isEmpty()) {
            return bodies;
        }
        Room room = room();
        listed.forEach(body -> room.add(body.x(), body.y(), body.radius()));
        SplitMix64 random = new SplitMix64(seed);
        for (int k = 0; k < fills.size(); k++) {
            int placed = fills.get(k).draw(random, room, bodies);
            if (placed < fills.get(k).count()) {
                throw new NoRoomException(k, placed);
            }
        }
        return bodies;
    }

    /** Room with nothing but walls and bumpers, for discs of these sizes. */
    private Room room() {
        double sum = 0;
        double largest = 0;
        for (Body body : listed) {
            sum += body.radius();
            largest = Math.max(largest, body.radius());
        }
        for (Fill fill : fills) {
            sum += fill.count() * (fill.radiusLow() + fill.radiusHigh()) / 2;
            largest = Math.max(largest, fill.radiusHigh());
        }
        for (Bumper bumper : field.bumpers()) {
            largest = Math.max(largest, bumper.radius());
        }
        Room room = new Room(field.walls(), sum / count(), largest);
        field.bumpers().forEach(bumper -> room.add(bumper.x(), bumper.y(), bumper.radius()));
        return room;
    }

    /** Told of a disc that cannot be where it is. */
    public interface Misplaced {

        /** @param other the lower index of the disc that it overlaps with; bumpers count before discs */
        void overlap(int body, int other);

        /** @param wall the index of a wall that it is in or behind */
        void wall(int body, int wall);
    }

    /** Looks at the listed discs, in their order. */
    public void check(Misplaced problem) {
        if (listed.isEmpty()) {
            return;
        }
        Room room = room();
        for (int k = 0; k < listed.size(); k++) {
            Body body = listed.get(k);
            int wall = room.wall(body.x(), body.y(), body.radius());
            int other = room.overlapped(body.x(), body.y(), body.radius());
            if (wall >= 0) {
                problem.wall(k, wall);
            } else if (other >= 0) {
                problem.overlap(k, other);
            }
            room.add(body.x(), body.y(), body.radius());
        }
    }
}
