package steward.game.podrace;

import java.util.List;

/**
 * A possible random start in which a pod stands in an obstacle, for an error message.
 *
 * @param map      its number among the maps of the scene
 * @param first    the checkpoint across which pods start
 * @param drawn    that checkpoint and the next, jitter included: {@code [2][x, y]}
 * @param obstacle what it stands in; {@code null} if the two checkpoints are in one place
 * @param depth    how deep, in u
 */
record StartOverlap(int map, int first, double[][] drawn, int pod, Obstacle obstacle, double depth) {

    /** Below this a negative gap is a rounding error of its arithmetic: coordinates are at most 1e6 u. */
    private static final double TOUCHING = 1e-6;

    /*
     * Gaps change by no more than places move. So a nominal gap above StartPlaces.slack is never closed, and a pod with
     * less is looked at for each of the extreme draws.
     */

    /**
     * The first such start, or {@code null}. Places are taken before rounding. With jitter, the deepest overlap is
     * looked for by descent from the extreme draws: what is found can be drawn; an overlap of less than about a unit
     * may be missed.
     */
    static StartOverlap find(PodRaceSettings settings, List<Obstacle> obstacles) {
        for (int map = 0; map < settings.maps().size(); map++) {
            double[][] checkpoints = settings.maps().get(map);
            for (int first = 0; first < (settings.shift() ? checkpoints.length : 1); first++) {
                double[][] ends = {checkpoints[first], checkpoints[(first + 1) % checkpoints.length]};
                StartOverlap found = new Start(settings, map, first, ends).find(obstacles);
                if (found != null) {
                    return found;
                }
            }
        }
        return null;
    }

    /** One start before jitter. */
    private static final class Start {

        private final PodRaceSettings settings;
        private final int map;
        private final int first;
        private final double[][] ends;
        private final int pods;
        private final int jitter;
        private final double length;

        Start(PodRaceSettings settings, int map, int first, double[][] ends) {
            this.settings = settings;
            this.map = map;
            this.first = first;
            this.ends = ends;
            pods = settings.pods();
            jitter = settings.jitter();
            double dx = ends[1][0] - ends[0][0];
            double dy = ends[1][1] - ends[0][1];
            length = Math.sqrt(dx * dx + dy * dy);
        }

        StartOverlap find(List<Obstacle> obstacles) {
            if (canCoincide(0) && canCoincide(1)) {
                return new StartOverlap(map, first, ends, 0, null, 0);
            }
            for (Obstacle obstacle : obstacles) {
                StartOverlap found = find(obstacle, 0, pods - 1);
                if (found != null) {
                    return found;
                }
            }
            return null;
        }

        private boolean canCoincide(int axis) {
            double apart = ends[1][axis] - ends[0][axis];
            return Math.abs(apart) <= 2 * jitter && apart == Math.rint(apart);
        }

        /** Pods from the k-th to the last-th in the line across the checkpoint: halved until clear or single. */
        private StartOverlap find(Obstacle obstacle, int k, int last) {
            int middle = (k + last) / 2;
            int pod = podAt(middle);
            double reach = StartPlaces.START_SPACING * Math.max(middle - k, last - middle);
            if (gap(obstacle, pod, new int[4]) > reach + slack(k) + slack(last)) {
                return null;
            }
            if (k == last) {
                return deepest(obstacle, pod);
            }
            StartOverlap left = find(obstacle, k, middle);
            return left != null ? left : find(obstacle, middle + 1, last);
        }

        /** The pods in the order of their sides: ..., 4, 2, 0, 1, 3, ... */
        private int podAt(int place) {
            int even = (pods + 1) / 2;
            return place < even ? 2 * (even - 1 - place) : 2 * (place - even) + 1;
        }

        /** Returns how far jitter can move the pod at a place of the line. */
        private double slack(int place) {
            return StartPlaces.slack(StartPlaces.side(podAt(place), pods), jitter, length);
        }

        private StartOverlap deepest(Obstacle obstacle, int pod) {
            int[] best = new int[4];
            double least = gap(obstacle, pod, best);
            for (int corner = 0; corner < 16 && jitter > 0; corner++) {
                int[] draw = new int[4];
                for (int k = 0; k < 4; k++) {
                    draw[k] = (corner >> k & 1) == 0 ? -jitter : jitter;
                }
                double gap = descend(obstacle, pod, draw);
                if (gap < least) {
                    least = gap;
                    best = draw;
                }
            }
            return least >= -TOUCHING ? null
                : new StartOverlap(map, first, new double[][] {{ends[0][0] + best[0], ends[0][1] + best[1]},
                    {ends[1][0] + best[2], ends[1][1] + best[3]}}, pod, obstacle, -least);
        }

        /** Changes one coordinate of the draw at a time while the gap becomes smaller, in ever smaller steps. */
        private double descend(Obstacle obstacle, int pod, int[] draw) {
            double least = gap(obstacle, pod, draw);
            for (int step = jitter; step > 0; step /= 2) {
                for (int move = 0; move < 8; move++) {
                    int before = draw[move / 2];
                    draw[move / 2] = Math.max(-jitter, Math.min(jitter, before + (move % 2 == 0 ? step : -step)));
                    double gap = gap(obstacle, pod, draw);
                    if (gap < least) {
                        least = gap;
                    } else {
                        draw[move / 2] = before;
                    }
                }
            }
            return least;
        }

        private double gap(Obstacle obstacle, int pod, int[] draw) {
            double x = ends[0][0] + draw[0];
            double y = ends[0][1] + draw[1];
            double dx = ends[1][0] + draw[2] - x;
            double dy = ends[1][1] + draw[3] - y;
            double scale = StartPlaces.side(pod, pods) / Math.sqrt(dx * dx + dy * dy);
            return obstacle.gap().of(x - scale * dy, y + scale * dx, settings.radius());
        }
    }
}
