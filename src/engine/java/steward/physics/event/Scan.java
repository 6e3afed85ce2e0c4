package steward.physics.event;

import java.util.ArrayList;
import java.util.List;
import steward.physics.Bodies;
import steward.physics.ImpactLaw;
import steward.physics.PhysicsParts;
import steward.physics.Wall;
import steward.physics.time.PairTime;
import steward.physics.time.WallTime;

/** A search for impacts in the rest of a turn. A scene gets the scans for the parts that it has, and no others. */
sealed interface Scan {

    /** Offers every impact from {@code now} to the end of the turn. */
    void find(Bodies bodies, double now, ImpactQueue queue);

    /** The scans that a scene needs: pairs, and walls if there are any. */
    static Scan[] of(PhysicsParts parts, PairTime time) {
        return of(parts, time, new WallTime.Plain(parts.walls().toArray(new Wall[0])));
    }

    /** Returns the scans that a scene needs, with another computation of times of impact at walls. */
    static Scan[] of(PhysicsParts parts, PairTime time, WallTime wallTime) {
        List<Scan> scans = new ArrayList<>();
        boolean plain = parts.contacts().allBounce() && !parts.infiniteMasses();
        boolean descending = parts.law().scanOrder() == ImpactLaw.ScanOrder.DESCENDING;
        if (parts.contacts().bodiesMeet()) {
            PairTime within = parts.contacts().hasReaches() ? new PairTime.AtOwnDistance(time, parts.contacts()) : time;
            scans.add(!plain ? new SelectedPairs(within, new PairSelection(parts.contacts()), descending)
                : descending ? new DescendingPairs(time) : new AscendingPairs(time));
        }
        if (!parts.walls().isEmpty()) {
            scans.add(new Walls(wallTime, parts.walls().size(),
                parts.contacts().allBounce() ? null : new PairSelection(parts.contacts())));
        }
        return scans.toArray(new Scan[0]);
    }

    record AscendingPairs(PairTime time) implements Scan {

        @Override
        public void find(Bodies bodies, double now, ImpactQueue queue) {
            int size = bodies.size();
            for (int i = 0; i < size - 1; i++) {
                for (int j = i + 1; j < size; j++) {
                    offer(bodies, i, j, time, now, queue);
                }
            }
        }
    }

    record DescendingPairs(PairTime time) implements Scan {

        @Override
        public void find(Bodies bodies, double now, ImpactQueue queue) {
            for (int i = bodies.size() - 1; i > 0; i--) {
                for (int j = i - 1; j >= 0; j--) {
                    offer(bodies, i, j, time, now, queue);
                }
            }
        }
    }

    /** Leaves out pairs that ignore each other, pass through each other, or both have infinite mass. */
    record SelectedPairs(PairTime time, PairSelection selection, boolean descending) implements Scan {

        @Override
        public void find(Bodies bodies, double now, ImpactQueue queue) {
            int size = bodies.size();
            for (int first = 0; first < size - 1; first++) {
                int i = descending ? size - 1 - first : first;
                int others = size - 1 - first;
                for (int k = 1; k <= others; k++) {
                    int j = descending ? i - k : i + k;
                    if (selection.canReact(bodies, i, j)) {
                        offer(bodies, i, j, time, now, queue);
                    }
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

    /** Offers the impact of a pair if it falls into the turn. */
    private static void offer(Bodies bodies, int i, int j, PairTime time, double now, ImpactQueue queue) {
        double until = time.until(bodies, i, j);
        if (until <= 1 - now) {
            queue.offer(now + until, i, j);
        }
    }
}
