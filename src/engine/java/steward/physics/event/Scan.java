package steward.physics.event;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import steward.physics.Bodies;
import steward.physics.ImpactLaw;
import steward.physics.PhysicsParts;
import steward.physics.Wall;
import steward.physics.event.flight.PairSelection;
import steward.physics.time.PairTime;
import steward.physics.time.WallTime;

/** A search for impacts in the rest of a turn. A scene gets only the scans for the parts that it has. */
sealed interface Scan {

    /** Room for rounding in a box of places, as a share of what it is computed from. */
    double ROOM = 0x1p-20;

    /** Offers every impact from {@code now} to the end of the turn. */
    void find(Bodies bodies, double now, ImpactQueue queue);

    /** The scan for the rest of a turn in which bodies do nothing but stop. */
    default Scan whileStopping(Bodies bodies, double left) {
        return this;
    }

    /** The scans that a scene needs: pairs, and walls if there are any. */
    static Scan[] of(PhysicsParts parts, PairTime time) {
        return of(parts, time, new WallTime.Plain(parts.walls().toArray(new Wall[0])));
    }

    /** Returns the scans that a scene needs, with another computation of times of impact at walls. */
    static Scan[] of(PhysicsParts parts, PairTime time, WallTime wallTime) {
        List<Scan> scans = new ArrayList<>();
        boolean descending = parts.law().scanOrder() == ImpactLaw.ScanOrder.DESCENDING;
        if (parts.contacts().bodiesMeet()) {
            scans.add(new Pairs(time, PairSelection.of(parts), descending));
        }
        if (!parts.walls().isEmpty()) {
            scans.add(new Walls(wallTime, parts.walls().size(),
                parts.contacts().allBounce() ? null : new PairSelection(parts.contacts())));
        }
        return scans.toArray(new Scan[0]);
    }

    /** All pairs, or those that can react. @param selection {@code null} if all can */
    record Pairs(PairTime time, PairSelection selection, boolean descending) implements Scan {

        @Override
        public void find(Bodies bodies, double now, ImpactQueue queue) {
            int size = bodies.size();
            for (int first = 0; first < size - 1; first++) {
                int i = descending ? size - 1 - first : first;
                int others = size - 1 - first;
                for (int k = 1; k <= others; k++) {
                    int j = descending ? i - k : i + k;
                    if (selection == null || selection.canReact(bodies, i, j)) {
                        double until = time.until(bodies, i, j, PairSelection.radius(selection, bodies, i, j),
                            PairSelection.radius(selection, bodies, j, i));
                        if (until <= 1 - now) {
                            queue.offer(now + until, i, j);
                        }
                    }
                }
            }
        }

        /** Lists the pairs whose boxes of places until the end of the turn overlap, with room for rounding. */
        @Override
        public Scan whileStopping(Bodies bodies, double left) {
            int size = bodies.size();
            double[] west = new double[size];
            double[] east = new double[size];
            double[] north = new double[size];
            double[] south = new double[size];
            for (int i = 0; i < size; i++) {
                double x = bodies.x[i];
                double y = bodies.y[i];
                double wayX = bodies.vx[i] * left;
                double wayY = bodies.vy[i] * left;
                double radius = selection == null ? bodies.radius[i] : selection.widestRadius(bodies, i);
                double reach = radius + ROOM
                    * (Math.abs(x) + Math.abs(y) + Math.abs(wayX) + Math.abs(wayY) + radius);
                west[i] = x + Math.min(wayX, 0) - reach;
                east[i] = x + Math.max(wayX, 0) + reach;
                north[i] = y + Math.min(wayY, 0) - reach;
                south[i] = y + Math.max(wayY, 0) + reach;
            }
            int[] order = IntStream.range(0, size).boxed().sorted(Comparator.comparingDouble(i -> west[i]))
                .mapToInt(i -> i).toArray();
            IntStream.Builder pairs = IntStream.builder();
            for (int k = 0; k < size; k++) {
                int i = order[k];
                for (int n = k + 1; n < size && west[order[n]] <= east[i]; n++) {
                    int j = order[n];
                    if (north[i] <= south[j] && north[j] <= south[i]
                        && (selection == null || selection.canReact(bodies, i, j))) {
                        pairs.add(i < j != descending ? i : j).add(i < j != descending ? j : i);
                    }
                }
            }
            return new Listed(time, selection, pairs.build().toArray());
        }
    }

    /** Some of all pairs, two indices each. */
    record Listed(PairTime time, PairSelection selection, int[] pairs) implements Scan {

        @Override
        public void find(Bodies bodies, double now, ImpactQueue queue) {
            for (int k = 0; k < pairs.length; k += 2) {
                int i = pairs[k];
                int j = pairs[k + 1];
                double until = time.until(bodies, i, j, PairSelection.radius(selection, bodies, i, j),
                    PairSelection.radius(selection, bodies, j, i));
                if (until <= 1 - now) {
                    queue.offer(now + until, i, j);
                }
            }
        }
    }

    /** Every body against every wall. @param selection {@code null} when every body bounces off walls */
    record Walls(WallTime time, int count, PairSelection selection) implements Scan {

        @Override
        public void find(Bodies bodies, double now, ImpactQueue queue) {
            double left = 1 - now;
            for (int i = 0; i < bodies.size(); i++) {
                if (selection == null ? bodies.inverseMass[i] == 0 : !selection.canReactWithWalls(bodies, i)) {
                    continue;
                }
                for (int w = 0; w < count; w++) {
                    double until = time.until(bodies, i, w);
                    if (until <= left && (selection == null || selection.canReactWithWall(bodies, i, w))) {
                        queue.offer(now + until, i, ~w);
                    }
                }
            }
        }
    }
}
