import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Scanner;

/** A Poker Chip Race bot as a contestant writes it: chases the nearest smaller chip when it has no speed. */
class Player {

    static class Entity {
        int id;
        int owner;
        float radius;
        float x;
        float y;
        float vx;
        float vy;
    }

    public static void main(String[] args) {
        Scanner in = new Scanner(System.in).useLocale(Locale.US);
        int playerId = in.nextInt();
        while (in.hasNextInt()) {
            int playerChipCount = in.nextInt();
            int entityCount = in.nextInt();
            List<Entity> entities = new ArrayList<>();
            for (int i = 0; i < entityCount; i++) {
                Entity e = new Entity();
                e.id = in.nextInt();
                e.owner = in.nextInt();
                e.radius = in.nextFloat();
                e.x = in.nextFloat();
                e.y = in.nextFloat();
                e.vx = in.nextFloat();
                e.vy = in.nextFloat();
                entities.add(e);
            }
            for (int i = 0; i < playerChipCount; i++) {
                Entity me = entities.get(i);
                if (me.owner != playerId) {
                    throw new IllegalStateException("own chips come first");
                }
                Entity prey = null;
                for (Entity e : entities) {
                    if (e != me && e.radius < me.radius && (prey == null || far(e, me) < far(prey, me))) {
                        prey = e;
                    }
                }
                System.out.println(prey == null || Math.hypot(me.vx, me.vy) > 20 ? "WAIT no hurry"
                    : prey.x + " " + prey.y + " yum");
            }
        }
    }

    static double far(Entity a, Entity b) {
        return Math.hypot(a.x - b.x, a.y - b.y);
    }
}
