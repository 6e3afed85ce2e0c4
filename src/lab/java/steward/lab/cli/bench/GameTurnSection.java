package steward.lab.cli.bench;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import steward.cli.shared.Games;
import steward.game.FrameCodec;
import steward.game.Game;
import steward.game.GameSetup;
import steward.game.Pilot;
import steward.lab.bench.Contender;
import steward.lab.bench.Effort;
import steward.lab.bench.GroupSection;
import steward.lab.bench.Row;
import steward.lab.bench.Section;
import steward.numerics.SplitMix64;
import steward.scene.SceneFiles;

/** A turn of every game but the first, which has a section of its own: answers are read and the turn is played. */
final class GameTurnSection implements Section {

    private static final int GAMES = 8;
    /** Turns of the one game of a scene without players, which may take milliseconds each. */
    private static final int MOST_TURNS = 25;
    private static final long SEED = 1;

    private final List<String> scenes = SceneFiles.shipped().stream()
        .filter(scene -> !Games.open(scene).scene().gameId().equals(Games.FIRST)).toList();

    @Override
    public String name() {
        return "games";
    }

    @Override
    public String about() {
        return "Turns of whole games in the scenes of the other games, by CPU time: the answers of seeded pilots, known"
            + " beforehand, are read as JSON, and the turn is played. " + GAMES + " games each; " + MOST_TURNS
            + " turns of one game where nobody plays.";
    }

    @Override
    public int steps(Effort effort) {
        return GroupSection.steps(scenes.size(), effort);
    }

    @Override
    public void run(Effort effort, Consumer<String> about, Consumer<Row> rows) throws Exception {
        List<GroupSection.Group> groups = new ArrayList<>();
        for (String scene : scenes) {
            Answers answers = new Answers(Games.open(scene));
            groups.add(new GroupSection.Group("turns", List.of(new Contender(scene, answers::play))));
        }
        new GroupSection(name(), about(), groups).run(effort, about, rows);
    }

    /** Games of which all answers are known. */
    private static final class Answers {

        private final GameSetup setup;
        /** By game, turn and player; {@code null} for a player who is not asked. */
        private final List<List<byte[][]>> answers = new ArrayList<>();
        private long end;

        Answers(GameSetup setup) {
            this.setup = setup;
            Pilot pilot = setup.pilot(Pilot.Aim.WIN);
            boolean played = setup.create(SEED).players() > 0;
            for (int number = 0; number < (played ? GAMES : 1); number++) {
                SplitMix64 random = new SplitMix64(SEED + number);
                Game game = setup.create(SEED + number);
                FrameCodec codec = setup.codec(game);
                List<byte[][]> turns = new ArrayList<>();
                while (!game.isOver() && (played || game.turn() < MOST_TURNS)) {
                    byte[][] lines = new byte[game.players()][];
                    for (int player = 0; player < lines.length; player++) {
                        lines[player] = game.isIn(player)
                            ? pilot.answer(game, player, random).getBytes(StandardCharsets.UTF_8) : null;
                    }
                    turns.add(lines);
                    turn(game, codec, lines);
                }
                answers.add(turns);
                end ^= game.hash();
            }
        }

        private static void turn(Game game, FrameCodec codec, byte[][] lines) {
            for (int player = 0; player < lines.length; player++) {
                if (lines[player] != null) {
                    codec.frames().readAnswer(player, lines[player], lines[player].length);
                }
            }
            game.play();
        }

        long play() {
            long found = 0;
            long turns = 0;
            for (int number = 0; number < answers.size(); number++) {
                Game game = setup.create(SEED + number);
                FrameCodec codec = setup.codec(game);
                for (byte[][] lines : answers.get(number)) {
                    turn(game, codec, lines);
                }
                turns += game.turn();
                found ^= game.hash();
            }
            if (found != end) {
                throw new IllegalStateException("games of " + setup.scene().name() + " end otherwise than before");
            }
            return turns;
        }
    }
}
