package steward.game.fantasticbits.protocol;

import java.util.ArrayList;
import java.util.List;
import steward.game.ServerView;
import steward.game.ShownSeed;
import steward.game.fantasticbits.EntityKind;
import steward.game.fantasticbits.Pitch;
import steward.json.JsonNumbers;
import steward.json.JsonObject;
import steward.scene.SceneFiles;
import steward.text.ViewLines;
import tools.jackson.core.JsonGenerator;

/**
 * A match of Fantastic Bits as the views of the server show it; the form is that of the published referee:
 * <pre>
 * line 0      the number of the frame
 * frame 0     Fantastic Bits
 *             width height wizardRadius wizards snaffleRadius goalSize
 *             player x y of each wizard; id x y of each snaffle; of each bludger          a line each
 * then        a line for each wizard, x y vx vy power targetX targetY message
 *             how many spells are at work, and a line for each
 *             how many snaffles there are, and id x y inPlay of each; how many bludgers, and id x y of each
 *             a score per player; the magic of each; then what has met, in order
 * </pre>
 * The input of the server's referee, {@code refereeInput}, has a line {@code seed=}. Which variant was played it does
 * not tell: today's is taken.
 */
final class FantasticBitsShown implements ServerView.Shown {

    private static final int FIRST_LINE_OF_START = 6;
    private static final int MOST = 1000;

    private final long seed;
    private final Turn start;
    private final List<Turn> turns = new ArrayList<>();

    /** @param owner of a wizard, otherwise -1 */
    private record Entity(int id, EntityKind kind, int owner, long x, long y, long vx, long vy) { }

    private record Turn(List<Entity> entities, int[] scores, int[] magic) { }

    FantasticBitsShown(ViewLines first, String input) {
        seed = ShownSeed.required(input, first.source());
        start = read(first, FIRST_LINE_OF_START);
    }

    @Override
    public String scene() {
        return SceneFiles.load("fantastic-bits").text();
    }

    @Override
    public long seed() {
        return seed;
    }

    @Override
    public void add(ViewLines view) {
        turns.add(view.count() == 0 ? null : read(view, 1));
    }

    private static Turn read(ViewLines view, int first) {
        List<Entity> entities = new ArrayList<>();
        int line = first;
        for (; entities.size() < Pitch.WIZARDS; line++) {
            String[] words = words(view, line, 7, "a wizard: x y vx vy power targetX targetY");
            entities.add(new Entity(entities.size(), EntityKind.WIZARD, Pitch.playerOf(entities.size()),
                view.whole(words[0], line), view.whole(words[1], line), view.whole(words[2], line),
                view.whole(words[3], line)));
        }
        line += 1 + count(view, line, "spells");
        int snaffles = line + count(view, line, "snaffles");
        for (line++; line <= snaffles; line++) {
            String[] words = words(view, line, 4, "a snaffle: id x y inPlay");
            if (view.whole(words[3], 1, line) == 1) {
                entities.add(entity(view, line, words, EntityKind.SNAFFLE));
            }
        }
        int bludgers = line + count(view, line, "bludgers");
        for (line++; line <= bludgers; line++) {
            entities.add(entity(view, line, words(view, line, 3, "a bludger: id x y"), EntityKind.BLUDGER));
        }
        return new Turn(entities, players(view, line, "the scores of two players"),
            players(view, line + 1, "the magic of two players"));
    }

    private static Entity entity(ViewLines view, int line, String[] words, EntityKind kind) {
        return new Entity(view.whole(words[0], MOST, line), kind, -1, view.whole(words[1], line),
            view.whole(words[2], line), 0, 0);
    }

    private static String[] words(ViewLines view, int line, int least, String expected) {
        String[] words = view.words(line);
        if (words.length < least) {
            throw view.wrong(line, expected);
        }
        return words;
    }

    private static int count(ViewLines view, int line, String what) {
        return view.whole(words(view, line, 1, "how many " + what + " there are")[0], MOST, line);
    }

    private static int[] players(ViewLines view, int line, String expected) {
        String[] words = words(view, line, 2, expected);
        return new int[] {(int) view.whole(words[0], line), (int) view.whole(words[1], line)};
    }

    @Override
    public void writeStart(JsonGenerator out) {
        writeBodies(out, start);
    }

    @Override
    public void writeOutcome(JsonGenerator out, int number) {
        Turn turn = turns.get(number - 1);
        if (turn == null) {
            return;
        }
        out.writeName("scores");
        out.writeArray(turn.scores, 0, turn.scores.length);
        JsonObject.writeAll(out, "resources", turn.magic.length,
            player -> out.writeNumberProperty("magic", turn.magic[player]));
        out.writeObjectPropertyStart("state");
        writeBodies(out, turn);
        out.writeEndObject();
    }

    private static void writeBodies(JsonGenerator out, Turn turn) {
        JsonObject.writeAll(out, "bodies", turn.entities, entity -> {
            out.writeNumberProperty("id", entity.id);
            out.writeStringProperty("kind", entity.kind.text());
            if (entity.owner >= 0) {
                out.writeNumberProperty("player", entity.owner);
            }
            JsonNumbers.write(out, "x", entity.x);
            JsonNumbers.write(out, "y", entity.y);
            if (entity.kind == EntityKind.WIZARD) {
                JsonNumbers.write(out, "vx", entity.vx);
                JsonNumbers.write(out, "vy", entity.vy);
            }
        });
    }
}
