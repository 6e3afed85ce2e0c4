package steward.physics.event;

import java.util.ArrayList;
import java.util.List;

/**
 * A second official pod-race turn, written from steps 2 and 3 of its description alone, with objects and lists where
 * the engine has arrays: it is slow and plain, and the engine must agree with it to the last bit.
 */
final class NaiveOfficialTurn {

    /** A pod. */
    static final class Pod {
        double x;
        double y;
        double vx;
        double vy;
        double mass;
    }

    /** An impact found (then j is NaN) or done. */
    record Hit(double time, int i, int j, double impulse) {
    }

    private final List<Pod> pods;
    private final List<Hit> done = new ArrayList<>();

    NaiveOfficialTurn(List<Pod> pods) {
        this.pods = pods;
    }

    /** Step 2: from t = 0 to 1. */
    List<Hit> advance() {
        double t = 0;
        List<Hit> list = found(t);
        while (!list.isEmpty()) {
            double earliest = list.get(0).time;
            move(earliest - t);
            t = earliest;
            for (Hit hit : list) {
                if (hit.time - earliest <= 1e-5) {
                    react(hit);
                }
            }
            if (done.size() > 100_000) {
                throw new AssertionError("hangs");
            }
            list = found(t);
        }
        move(1 - t);
        return done;
    }

    private List<Hit> found(double t) {
        List<Hit> list = new ArrayList<>();
        for (int i = pods.size() - 1; i >= 1; i--) {
            for (int j = i - 1; j >= 0; j--) {
                Pod p = pods.get(i);
                Pod q = pods.get(j);
                double dx = p.x - q.x;
                double dy = p.y - q.y;
                if (Math.sqrt(dx * dx + dy * dy) <= 800) {
                    list.add(new Hit(t, i, j, Double.NaN));
                    continue;
                }
                double vx = p.vx - q.vx;
                double vy = p.vy - q.vy;
                double a = vx * vx + vy * vy;
                double b = dx * vx + dy * vy;
                double c = dx * dx + dy * dy - 800.0 * 800.0;
                double discriminant = b * b - a * c;
                if (discriminant <= 0 || a == 0) {
                    continue;
                }
                double one = (-b + Math.sqrt(discriminant)) / a;
                double other = (-b - Math.sqrt(discriminant)) / a;
                double root = one < other ? one : other;
                if (0 < root && root <= 1 - t) {
                    list.add(new Hit(t + root, i, j, Double.NaN));
                }
            }
        }
        list.sort((first, second) -> Double.compare(first.time, second.time));
        return list;
    }

    private void react(Hit hit) {
        Pod i = pods.get(hit.i);
        Pod j = pods.get(hit.j);
        double nx = j.x - i.x;
        double ny = j.y - i.y;
        double distance = Math.sqrt(nx * nx + ny * ny);
        nx /= distance;
        ny /= distance;
        double f = (nx * (i.vx - j.vx) + ny * (i.vy - j.vy)) / (1 / i.mass + 1 / j.mass);
        double impulse = f + (f < 120 ? 120 : f);
        i.vx -= nx * impulse * (1 / i.mass);
        i.vy -= ny * impulse * (1 / i.mass);
        j.vx += nx * impulse * (1 / j.mass);
        j.vy += ny * impulse * (1 / j.mass);
        if (distance <= 800) {
            double push = (800 - distance) / 2 + 1e-5;
            i.x -= nx * push;
            i.y -= ny * push;
            j.x += nx * push;
            j.y += ny * push;
        }
        done.add(new Hit(hit.time, hit.i, hit.j, impulse));
    }

    private void move(double time) {
        for (Pod pod : pods) {
            pod.x += pod.vx * time;
            pod.y += pod.vy * time;
        }
    }

    /** Step 3: speeds lose 15 % and are cut toward zero, positions are rounded, halves up. */
    void end() {
        for (Pod pod : pods) {
            pod.vx = (long) (pod.vx * (1 - 0.15));
            pod.vy = (long) (pod.vy * (1 - 0.15));
            pod.x = Math.floor(pod.x + 0.5);
            pod.y = Math.floor(pod.y + 0.5);
        }
    }
}
