import java.util.ArrayList;
import java.util.List;
import java.util.Scanner;

/** A Mean Max bot as a contestant writes it: everything heads for the others, grenades when there is rage. */
class Player {

    public static void main(String[] args) {
        Scanner in = new Scanner(System.in);
        while (in.hasNextInt()) {
            int myScore = in.nextInt();
            int enemyScore1 = in.nextInt();
            int enemyScore2 = in.nextInt();
            int myRage = in.nextInt();
            int enemyRage1 = in.nextInt();
            int enemyRage2 = in.nextInt();
            int count = in.nextInt();
            List<int[]> units = new ArrayList<>();
            for (int i = 0; i < count; i++) {
                int[] unit = new int[10];
                unit[0] = in.nextInt();
                unit[1] = in.nextInt();
                unit[2] = in.nextInt();
                float mass = in.nextFloat();
                for (int k = 3; k < 10; k++) {
                    unit[k] = in.nextInt();
                }
                units.add(unit);
            }
            int[] destroyer = find(units, 1, 0);
            int[] prey = nearest(units, destroyer, 3);
            int[] wreck = nearest(units, find(units, 0, 0), 4);
            int[] rival = find(units, 0, enemyScore1 >= enemyScore2 ? 1 : 2);
            System.out.println(wreck == null ? "WAIT for water" : wreck[4] + " " + wreck[5] + " 200");
            boolean near = Math.hypot(rival[4] - destroyer[4], rival[5] - destroyer[5]) < 2000;
            System.out.println(myRage >= 60 && near ? "SKILL " + rival[4] + " " + rival[5]
                : prey == null ? "0 0 300" : prey[4] + " " + prey[5] + " 300 ram");
            System.out.println(rival[4] + " " + rival[5] + " 300");
        }
    }

    static int[] find(List<int[]> units, int type, int player) {
        for (int[] unit : units) {
            if (unit[1] == type && unit[2] == player) {
                return unit;
            }
        }
        return null;
    }

    static int[] nearest(List<int[]> units, int[] from, int type) {
        int[] best = null;
        for (int[] unit : units) {
            if (unit[1] == type && (best == null || far(unit, from) < far(best, from))) {
                best = unit;
            }
        }
        return best;
    }

    static double far(int[] a, int[] b) {
        return Math.hypot(a[4] - b[4], a[5] - b[5]);
    }
}
