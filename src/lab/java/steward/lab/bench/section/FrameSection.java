package steward.lab.bench.section;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.function.Consumer;
import steward.bot.LineBuffer;
import steward.game.Game;
import steward.lab.bench.Contender;
import steward.lab.bench.Effort;
import steward.lab.bench.Meter;
import steward.lab.bench.Row;
import steward.lab.bench.Section;
import steward.match.Dialogue;
import steward.match.Protocol;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** Bench section on frames: the lines of one turn. */
final class FrameSection implements Section {

    private static final int PIECE = 1000;

    private final MatchFixture fixture;
    private final Consumer<Game> next;
    private final byte[] answer;

    /** @param next changes the game's state, at next to no cost: writing the same state again takes no work */
    FrameSection(MatchFixture fixture, Consumer<Game> next, String answer) {
        this.fixture = fixture;
        this.next = next;
        this.answer = answer.getBytes(StandardCharsets.UTF_8);
    }

    @Override
    public String name() {
        return "frames";
    }

    @Override
    public String about() {
        return "A turn's frames written, one for each player, and an answer read, by CPU time a line; every turn"
            + " everything has moved. The textbook's way goes through a tree of JSON nodes, which is there already when"
            + " it writes.";
    }

    @Override
    public int steps(Effort effort) {
        return 4 * (1 + effort.rounds());
    }

    @Override
    public void run(Effort effort, Consumer<String> about, Consumer<Row> rows) throws Exception {
        Game game = fixture.setup().create(1);
        Dialogue dialogue = Dialogue.of(Protocol.JSON, fixture.setup(), game, fixture.setup().codec(game));
        for (int turn = 0; turn < 10; turn++) {
            for (int player = 0; player < game.players(); player++) {
                String wrong = dialogue.readAnswer(player, answer, answer.length);
                if (wrong != null) {
                    throw new IllegalStateException("the answer is wrong: " + wrong);
                }
            }
            game.play();
        }
        LineBuffer line = dialogue.turn(0);
        JsonNode frame = JsonMapper.shared().readTree(Arrays.copyOf(line.bytes(), line.size()));
        List<Contender> writers = List.of(
            new Contender("textbook: frame from a tree", () -> repeat(() ->
                JsonMapper.shared().writeValueAsBytes(frame).length)),
            new Contender("frame", () -> game.players() * repeat(() -> frames(game, dialogue))));
        List<Contender> readers = List.of(
            new Contender("textbook: answer to a tree", () -> repeat(() ->
                JsonMapper.shared().readTree(answer).size())),
            new Contender("answer", () -> repeat(() ->
                dialogue.readAnswer(0, answer, answer.length) == null ? 1 : 0)));
        new Meter().compare(name(), "lines", writers, effort, about, rows);
        new Meter().compare(name(), "lines", readers, effort, about, rows);
    }

    private int frames(Game game, Dialogue dialogue) {
        next.accept(game);
        int size = 0;
        for (int player = 0; player < game.players(); player++) {
            size += dialogue.turn(player).size();
        }
        return size;
    }

    /** Writes or reads one or several lines. */
    private interface Line {
        int run();
    }

    private static long repeat(Line line) {
        for (int k = 0; k < PIECE; k++) {
            if (line.run() == 0) {
                throw new IllegalStateException("nothing was written or read");
            }
        }
        return PIECE;
    }
}
