#include <cmath>
#include <iostream>
#include <string>
#include <vector>
using namespace std;

// A Mean Max bot as a contestant writes it: follows its destroyer, tars rivals in wrecks, waits when nothing is near.

struct Unit { int id, type, player; float mass; int radius, x, y, vx, vy, extra, extra2; };

double far_(const Unit& a, const Unit& b) { return hypot(a.x - b.x, a.y - b.y); }

int main() {
    int myScore;
    while (cin >> myScore) {
        int enemyScore1, enemyScore2, myRage, enemyRage1, enemyRage2, count;
        cin >> enemyScore1 >> enemyScore2 >> myRage >> enemyRage1 >> enemyRage2 >> count;
        vector<Unit> units(count);
        for (Unit& u : units)
            cin >> u.id >> u.type >> u.player >> u.mass >> u.radius >> u.x >> u.y >> u.vx >> u.vy >> u.extra >> u.extra2;
        const Unit *mine[3] = {}, *wreck = nullptr, *tanker = nullptr, *rival = nullptr;
        for (const Unit& u : units) if (u.type < 3 && u.player == 0) mine[u.type] = &u;
        for (const Unit& u : units) {
            if (u.type == 4 && (!wreck || far_(u, *mine[0]) < far_(*wreck, *mine[0]))) wreck = &u;
            if (u.type == 3 && (!tanker || far_(u, *mine[1]) < far_(*tanker, *mine[1]))) tanker = &u;
            if (u.type == 0 && u.player > 0 && (!rival || far_(u, *mine[0]) < far_(*rival, *mine[0]))) rival = &u;
        }
        if (wreck && far_(*wreck, *mine[0]) < wreck->radius) {
            if (myRage >= 30 && rival && far_(*rival, *mine[0]) < 1500) cout << "SKILL " << rival->x << " " << rival->y << endl;
            else cout << wreck->x << " " << wreck->y << " " << (int) min(300.0, far_(*wreck, *mine[0]) / 3) << endl;
        } else if (wreck) {
            cout << wreck->x - mine[0]->vx << " " << wreck->y - mine[0]->vy << " 300" << endl;
        } else {
            cout << mine[1]->x << " " << mine[1]->y << " 150 following" << endl;
        }
        if (tanker) cout << tanker->x << " " << tanker->y << " 300" << endl; else cout << "wait" << endl;
        cout << rival->x << "  " << rival->y << " 300 doof" << endl;
    }
}
