// A contestant's bot in C++: plays both leagues, which it tells apart by the first line it reads.
#include <cmath>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

using namespace std;

struct Point {
    int x, y;
};

// One pod a player: the checkpoint, its distance and the angle to it are given.
void raceAlone(string line) {
    bool boosted = false;
    do {
        int x, y, nextX, nextY, dist, angle;
        istringstream(line) >> x >> y >> nextX >> nextY >> dist >> angle;
        int opponentX, opponentY;
        cin >> opponentX >> opponentY;
        cin.ignore();
        cout << nextX << " " << nextY << " ";
        if (!boosted && abs(angle) < 5 && dist > 4000) {
            cout << "BOOST go" << endl;
            boosted = true;
        } else if (abs(angle) > 90) {
            cout << 0 << endl;
        } else {
            cout << (dist < 1500 ? 50 : 100) << endl;
        }
    } while (getline(cin, line));
}

int main() {
    string line;
    getline(cin, line);
    if (line.find(' ') != string::npos) {
        raceAlone(line);
        return 0;
    }
    int checkpointCount;
    cin >> checkpointCount;
    vector<Point> checkpoints(checkpointCount);
    for (Point& c : checkpoints) cin >> c.x >> c.y;
    for (int turn = 0;; turn++) {
        int x[4], y[4], vx[4], vy[4], angle[4], next[4];
        for (int i = 0; i < 4; i++) {
            if (!(cin >> x[i] >> y[i] >> vx[i] >> vy[i] >> angle[i] >> next[i])) return 0;
        }
        for (int i = 0; i < 2; i++) {
            double targetX = checkpoints[next[i]].x - 3.5 * vx[i];      // printed as it is, with its decimals
            double targetY = checkpoints[next[i]].y - 3.5 * vy[i];
            double wanted = atan2(targetY - y[i], targetX - x[i]) * 180 / M_PI;
            double off = angle[i] < 0 ? 0 : fabs(remainder(wanted - angle[i], 360));
            cout << targetX << " " << targetY << " ";
            if (turn == 0) cout << "BOOST" << endl;
            else cout << (off > 90 ? 0 : 200) << " pod " << i << endl;
        }
    }
}
