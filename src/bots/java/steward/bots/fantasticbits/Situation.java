package steward.bots.fantasticbits;

import java.util.ArrayList;
import java.util.List;

/** A bot's knowledge in a turn: its number, where it scores, magic, and all entities. */
final class Situation {

    int player;
    double width = 16000;
    double height = 7500;
    /** The goal in which the bot scores. */
    double goalX = 16000;
    double goalTop = 1750;
    double goalBottom = 5750;
    final List<Integer> magic = new ArrayList<>();
    final List<Entity> entities = new ArrayList<>();

    /** The own two wizards, by id. */
    List<Entity> own() {
        List<Entity> wizards = of("wizard");
        wizards.removeIf(wizard -> wizard.player != player);
        return wizards;
    }

    /** The entities of a kind, by id. */
    List<Entity> of(String kind) {
        List<Entity> found = new ArrayList<>();
        for (Entity entity : entities) {
            if (entity.kind.equals(kind)) {
                found.add(entity);
            }
        }
        return found;
    }

    /** The middle of the goal, downward, in u. */
    double goalY() {
        return (goalTop + goalBottom) / 2;
    }

    /** The own magic. */
    int ownMagic() {
        return magic.get(player);
    }
}
