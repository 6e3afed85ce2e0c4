// A starter bot for the pod race: copy it and make it better.
//
// It speaks CodinGame's lines. At the start: laps, the number of checkpoints, and one line "x y" for each.
// Every turn: four lines "x y vx vy angle nextCheckpoint", your two pods first, then the other player's.
// Answer every turn with one line for each of your pods: "x y thrust", a place to steer at and 0 to 200;
// in place of the thrust you can say SHIELD or BOOST (the boost works once). Use std::cerr for notes.
#include <cmath>
#include <iostream>
#include <vector>

struct Place { int x, y; };
struct Pod { int x, y, vx, vy, angle, next; };

const int OWN = 2;
const int OTHERS = 2;
const int DRIFT_TURNS = 4;      // how many turns of its own speed a pod takes into account when it aims
const int FULL_THRUST = 200;
const double DEGREES = 180 / std::acos(-1.0);

bool read(Pod& pod) {
    return bool(std::cin >> pod.x >> pod.y >> pod.vx >> pod.vy >> pod.angle >> pod.next);
}

void command(const Pod& pod, const std::vector<Place>& checkpoints) {
    // A pod keeps most of its speed from turn to turn. Aim beside the checkpoint, against that drift.
    int x = checkpoints[pod.next].x - DRIFT_TURNS * pod.vx;
    int y = checkpoints[pod.next].y - DRIFT_TURNS * pod.vy;
    // A pod can turn by only 18 degrees a turn, so give no thrust while it looks elsewhere (-1: looks nowhere yet).
    double wanted = std::atan2(y - pod.y, x - pod.x) * DEGREES;
    double off = std::remainder(wanted - pod.angle, 360);       // -180..180, 0 is straight ahead
    int thrust = pod.angle >= 0 && std::abs(off) > 80 ? 0 : FULL_THRUST;
    std::cout << x << ' ' << y << ' ' << thrust << '\n';
}

int main() {
    int laps, count;
    std::cin >> laps >> count;
    std::vector<Place> checkpoints(count);
    for (Place& place : checkpoints) {
        std::cin >> place.x >> place.y;
    }
    for (;;) {                                          // until the referee closes our input
        std::vector<Pod> pods(OWN + OTHERS);
        for (Pod& pod : pods) {
            if (!read(pod)) {
                return 0;
            }
        }
        for (int k = 0; k < OWN; k++) {
            command(pods[k], checkpoints);
        }
        std::cout << std::flush;                        // without it the referee would wait in vain
    }
}
