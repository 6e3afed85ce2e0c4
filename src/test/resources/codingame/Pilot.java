import java.util.Scanner;

/** A contestant's bot in Java: plays both leagues, which it tells apart by the first line it reads. */
class Player {

    public static void main(String[] args) {
        Scanner in = new Scanner(System.in);
        String first = in.nextLine();
        if (first.contains(" ")) {
            raceAlone(first, in);
        } else {
            race(in);
        }
    }

    private static void raceAlone(String first, Scanner in) {
        Scanner line = new Scanner(first);
        while (true) {
            int x = line.nextInt();
            int y = line.nextInt();
            int nextX = line.nextInt();
            int nextY = line.nextInt();
            int dist = line.nextInt();
            int angle = line.nextInt();
            int opponentX = in.nextInt();
            int opponentY = in.nextInt();
            in.nextLine();
            System.err.println("[PDATA] dist = " + dist);
            if (Math.hypot(opponentX - x, opponentY - y) < 850) {
                System.out.println(nextX + " " + nextY + " SHIELD");
            } else {
                System.out.println(nextX + " " + nextY + " " + (Math.abs(angle) > 90 ? 5 : 100));
            }
            if (!in.hasNextLine()) {
                return;
            }
            line = new Scanner(in.nextLine());
        }
    }

    private static void race(Scanner in) {
        int checkpointCount = in.nextInt();
        int[] checkpointX = new int[checkpointCount];
        int[] checkpointY = new int[checkpointCount];
        for (int i = 0; i < checkpointCount; i++) {
            checkpointX[i] = in.nextInt();
            checkpointY[i] = in.nextInt();
        }
        while (in.hasNextInt()) {
            for (int i = 0; i < 4; i++) {
                int x = in.nextInt();
                int y = in.nextInt();
                int vx = in.nextInt();
                int vy = in.nextInt();
                int angle = in.nextInt();
                int next = in.nextInt();
                if (i < 2) {
                    int targetX = checkpointX[next] - 3 * vx;
                    int targetY = checkpointY[next] - 3 * vy;
                    double wanted = Math.toDegrees(Math.atan2(targetY - y, targetX - x));
                    double off = angle < 0 ? 0 : Math.abs(Math.IEEEremainder(wanted - angle, 360));
                    System.out.println(targetX + " " + targetY + " " + (off > 60 ? 20 : 200));
                }
            }
            System.err.println("[PDATA+] turns = 1");
        }
    }
}
