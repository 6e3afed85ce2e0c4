import java.util.ArrayList;
import java.util.List;
import java.util.Scanner;

/** A Fantastic Bits bot as a contestant writes it: it calls snaffles from afar, and stops the others' throws. */
class Player {

    public static void main(String[] args) {
        Scanner in = new Scanner(System.in);
        int myTeamId = in.nextInt();
        int goal = myTeamId == 0 ? 16000 : 0;
        while (in.hasNextInt()) {
            int myScore = in.nextInt();
            int myMagic = in.nextInt();
            int opponentScore = in.nextInt();
            int opponentMagic = in.nextInt();
            int count = in.nextInt();
            List<int[]> wizards = new ArrayList<>();
            List<int[]> snaffles = new ArrayList<>();
            for (int i = 0; i < count; i++) {
                int id = in.nextInt();
                String type = in.next();
                int[] entity = {id, in.nextInt(), in.nextInt(), in.nextInt(), in.nextInt(), in.nextInt()};
                if (type.equals("WIZARD")) {
                    wizards.add(entity);
                } else if (type.equals("SNAFFLE")) {
                    snaffles.add(entity);
                }
            }
            int[] chased = null;
            for (int[] wizard : wizards) {
                int[] best = null;
                for (int[] snaffle : snaffles) {
                    if ((snaffle != chased || snaffles.size() == 1)
                        && (best == null || far(snaffle, wizard) < far(best, wizard))) {
                        best = snaffle;
                    }
                }
                chased = best;
                boolean toOwnGoal = best != null && (goal == 16000 ? best[3] < -600 : best[3] > 600);
                if (wizard[5] == 1) {
                    System.out.println("THROW " + goal + " 3750 500");
                } else if (best == null) {
                    System.out.println("MOVE 8000 3750 150 nothing left");
                } else if (toOwnGoal && best[5] == 0 && myMagic >= 10) {
                    System.out.println("PETRIFICUS " + best[0]);
                    myMagic -= 10;
                } else if (far(best, wizard) > 3000 && myMagic >= 40) {
                    System.out.println("ACCIO " + best[0] + " come here");
                    myMagic -= 20;
                } else {
                    System.out.println("MOVE " + best[1] + " " + best[2] + " 150");
                }
            }
        }
    }

    static double far(int[] a, int[] b) {
        return Math.hypot(a[1] - b[1], a[2] - b[2]);
    }
}
