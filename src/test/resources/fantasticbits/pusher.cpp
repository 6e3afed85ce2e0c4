#include <cmath>
#include <iostream>
#include <string>
#include <vector>
using namespace std;

// A Fantastic Bits bot as a contestant writes it: one wizard pushes snaffles with spells, the other stays back.

struct Entity { int id; string type; int x, y, vx, vy, state; };

double far_(const Entity& a, const Entity& b) { return hypot(a.x - b.x, a.y - b.y); }

int main() {
    int team;
    cin >> team; cin.ignore();
    int goalX = team == 0 ? 16000 : 0, ownX = 16000 - goalX;
    while (true) {
        int myScore, myMagic, otherScore, otherMagic, count;
        if (!(cin >> myScore >> myMagic >> otherScore >> otherMagic >> count)) break;
        vector<Entity> wizards, snaffles;
        for (int k = 0; k < count; k++) {
            Entity e;
            cin >> e.id >> e.type >> e.x >> e.y >> e.vx >> e.vy >> e.state;
            if (e.type == "WIZARD") wizards.push_back(e);
            if (e.type == "SNAFFLE") snaffles.push_back(e);
        }
        for (int w = 0; w < 2; w++) {
            const Entity& me = wizards[w];
            const Entity* best = nullptr;
            for (const Entity& s : snaffles) {
                double cost = far_(me, s) + (w == 1 ? 0.5 * abs(s.x - ownX) : 0);
                if (!best || cost < far_(me, *best) + (w == 1 ? 0.5 * abs(best->x - ownX) : 0)) best = &s;
            }
            if (me.state == 1) cout << "THROW " << goalX << " " << (me.y > 3750 ? 4500 : 3000) << " 500" << endl;
            else if (!best) cout << "MOVE " << me.x << " " << me.y << " 0" << endl;
            else if (myMagic >= 20 && (best->x - me.x) * (goalX - best->x) > 0 && far_(me, *best) > 1000
                     && abs(goalX - best->x) < 6000) {
                cout << "FLIPENDO " << best->id << " push" << endl;
                myMagic -= 20;
            } else cout << "MOVE " << best->x << " " << best->y << " 150" << endl;
        }
    }
}
