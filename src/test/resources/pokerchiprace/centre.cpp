#include <cmath>
#include <iostream>
#include <vector>
using namespace std;

// A Poker Chip Race bot as a contestant writes it: every tenth turn each chip is pushed to the middle of its prey.

struct Chip { int id, owner; double r, x, y, vx, vy; };

int main() {
    int player, own, count, turn = 0;
    cin >> player;
    while (cin >> own >> count) {
        vector<Chip> chips(count);
        for (Chip& c : chips) cin >> c.id >> c.owner >> c.r >> c.x >> c.y >> c.vx >> c.vy;
        for (int i = 0; i < own; i++) {
            double x = 0, y = 0, all = 0;
            for (const Chip& c : chips) {
                if (c.r >= chips[i].r || c.owner == player) continue;
                double near = 1 / (1 + hypot(c.x - chips[i].x, c.y - chips[i].y));
                x += c.x * near; y += c.y * near; all += near;
            }
            if (all > 0 && turn % 10 == i % 10) cout << x / all << " " << y / all << endl;
            else cout << "WAIT" << endl;
        }
        turn++;
    }
}
