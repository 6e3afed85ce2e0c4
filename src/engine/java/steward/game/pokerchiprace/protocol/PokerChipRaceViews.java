package steward.game.pokerchiprace.protocol;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.IntUnaryOperator;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import steward.game.Game;
import steward.game.ShownMessages;
import steward.game.ViewWriter;
import steward.game.pokerchiprace.ChipCommand;
import steward.game.pokerchiprace.ChipEating;
import steward.game.pokerchiprace.ChipTable;
import steward.game.pokerchiprace.PokerChipRace;
import steward.numerics.StrictAngles;
import steward.physics.Bodies;
import steward.physics.TeeSink;
import steward.physics.TurnLog;
import steward.scene.Scene;
import tools.jackson.core.io.NumberOutput;

/**
 * Writer of views of the Poker Chip Race as the server shows them:
 * <pre>
 * line 0      the number of the frame
 * frame 0     PokerChipRace, then players, width, height, most turns
 * then        how many chips there are, and a line for each
 * a chip      id owner radius x y rotation points     places from the corner; radius -1.00: eaten in this turn
 *             and t x y radius rotation other         for each of the points, then its message
 * then        an area per player and of all chips; a score per player
 * </pre>
 * Every frame shows all chips; chips that were eaten in a turn come last in the frame that ends it, in the order in
 * which they were eaten.
 */
final class PokerChipRaceViews implements ViewWriter {

    private static final int LONGEST_MESSAGE = 20;
    private static final int PLACE = 2;
    private static final int AREA = 6;
    /** Words of a chip's line before its points, and of a point. */
    private static final int CHIP_WORDS = 7;
    private static final int POINT_WORDS = 6;

    private final Map<Integer, Double> rotations = new TreeMap<>();
    private final Map<Integer, Double> pushes = new TreeMap<>();
    private final List<List<Integer>> own = new ArrayList<>();
    private PokerChipRace game;
    private ChipPoints points;
    private boolean[] in;
    private boolean anyFailed;
    private final List<List<String>> answers = new ArrayList<>();

    @Override
    public List<String> notCompared() {
        return List.of("gameInformation, tooltips, summaries of players who are out",
            "messages in frames that do not end a turn",
            "of a turn in which a player fails messages, areas, scores and the word behind the number");
    }

    @Override
    public Scene observed(Scene scene) {
        return scene.withObserver((parts, advance) -> (bodies, sink) -> {
            turnPushed();
            points = new ChipPoints(bodies, rotations);
            advance.turn(bodies, new TeeSink(sink, points));
        });
    }

    @Override
    public void begin(Game of) {
        game = (PokerChipRace) of;
        in = new boolean[game.players()];
        keepWhoIsIn();
    }

    private void keepWhoIsIn() {
        for (int player = 0; player < in.length; player++) {
            in[player] = game.isIn(player);
        }
    }

    @Override
    public Frame start() {
        List<String> view = new ArrayList<>(List.of(ANY, PokerChipRaceView.TITLE, game.players() + " "
            + decimal(2 * ChipTable.HALF_WIDTH, 0) + " " + decimal(2 * ChipTable.HALF_HEIGHT, 0) + " "
            + game.settings().maximumTurns()));
        addChips(view, game::ownerOf, "");
        addScores(view, false);
        return new Frame(view, summary());
    }

    @Override
    public void before() {
        pushes.clear();
        answers.clear();
        own.clear();
        points = null;
        anyFailed = false;
        for (int player = 0; player < in.length; player++) {
            List<Integer> chips = new ArrayList<>();
            own.add(chips);
            for (int k = 0; k < game.table().owned(player); k++) {
                int chip = game.table().ownChip(player, k);
                chips.add(game.bodies().id(chip));
                ChipCommand command = game.command(player, k);
                if (command != null && !command.waits()) {
                    pushes.put(game.bodies().id(chip), StrictAngles.atan2(command.y() - game.bodies().y[chip],
                        command.x() - game.bodies().x[chip]));
                }
            }
            anyFailed |= in[player] && !game.isIn(player);
            if (in[player]) {
                answers.add(answered(player, anyFailed));
            }
        }
    }

    /** After the answer of a player: the chips of those who have failed so far belong to nobody. */
    private List<String> answered(int player, boolean failed) {
        List<String> view = new ArrayList<>(List.of(ANY + (failed ? " " + REST : "")));
        addChips(view, chip -> game.table().owner(chip) <= player ? game.ownerOf(chip) : game.table().owner(chip),
            " " + REST);
        addScores(view, failed);
        return view;
    }

    @Override
    public Frame answer(int answer) {
        return new Frame(answer < answers.size() ? answers.get(answer) : List.of(), null);
    }

    /** Called when all pushes are made: only chips that have ejected another were pushed, and look where they go. */
    private void turnPushed() {
        for (int chip = 0; chip < game.bodies().size(); chip++) {
            int parent = (int) game.bodies().columns[ChipTable.PARENT][chip];
            if (parent >= 0) {
                rotations.put(parent, pushes.get(parent));
            }
        }
    }

    @Override
    public Frame after(String[] messages, List<String> shown) {
        boolean ends = game.isOver() && game.turn() >= game.settings().maximumTurns();
        List<String> view = new ArrayList<>(List.of(ANY + " "
            + (anyFailed ? REST : ends ? "maxRoundsCountReached" : "")));
        addChips(view, game::ownerOf, "");
        for (int k = 0; points != null && k < game.log().facts(); k++) {
            TurnLog log = game.log();
            if (log.factKind(k) == ChipEating.EATEN) {
                view.add(chip(log.factA(k), (int) log.factP(k), -1, log.factX(k), log.factY(k)));
            }
        }
        view.set(1, Integer.toString(view.size() - 2));
        addMessages(view, messages, shown);
        addScores(view, anyFailed);
        keepWhoIsIn();
        return new Frame(view, summary());
    }

    private void addChips(List<String> view, IntUnaryOperator owner, String more) {
        Bodies bodies = game.bodies();
        view.add(Integer.toString(bodies.size()));
        for (int chip = 0; chip < bodies.size(); chip++) {
            view.add(chip(bodies.id(chip), owner.applyAsInt(chip), bodies.radius[chip], bodies.x[chip], bodies.y[chip])
                + more);
        }
    }

    private String chip(int id, int owner, double radius, double x, double y) {
        List<ChipPoints.Point> path = points == null ? List.of() : points.of(id);
        StringBuilder line = new StringBuilder(id + " " + owner + " " + decimal(radius, PLACE) + " " + place(x, y) + " "
            + decimal(rotations.getOrDefault(id, 0.0), PLACE) + " " + path.size());
        for (ChipPoints.Point point : path) {
            line.append(' ').append(decimal(point.time(), PLACE)).append(' ').append(place(point.x(), point.y()))
                .append(' ').append(decimal(point.radius(), PLACE)).append(' ').append(decimal(point.rotation(), PLACE))
                .append(' ').append(point.other());
        }
        return line.toString();
    }

    private static String place(double x, double y) {
        return decimal(x + ChipTable.HALF_WIDTH, PLACE) + " " + decimal(y + ChipTable.HALF_HEIGHT, PLACE);
    }

    /** A message stands at the end of the line of its chip, also of one that was eaten. */
    private void addMessages(List<String> view, String[] messages, List<String> shown) {
        for (int player = 0; player < in.length; player++) {
            ShownMessages said = new ShownMessages(messages[player], LONGEST_MESSAGE, LONGEST_MESSAGE, "");
            List<Integer> chips = own.get(player);
            for (int k = 0; k < chips.size(); k++) {
                int line = lineOf(view, chips.get(k));
                if (line > 0) {
                    String text = line < shown.size() ? message(shown.get(line)) : "";
                    view.set(line, view.get(line) + " "
                        + (anyFailed ? REST : said.next(text, k == chips.size() - 1)));
                }
            }
        }
    }

    private static int lineOf(List<String> view, int id) {
        for (int line = 2; line < view.size(); line++) {
            if (view.get(line).startsWith(id + " ")) {
                return line;
            }
        }
        return -1;
    }

    /** Rest of a chip's line behind its points. */
    private static String message(String line) {
        String[] words = line.strip().split("\\s+", CHIP_WORDS + 1);
        if (words.length <= CHIP_WORDS || !words[CHIP_WORDS - 1].matches("[0-9]{1,4}")) {
            return "";
        }
        int behind = POINT_WORDS * Integer.parseInt(words[CHIP_WORDS - 1]);
        String[] rest = words[CHIP_WORDS].split("\\s+", behind + 1);
        return rest.length <= behind ? "" : rest[behind];
    }

    private void addScores(List<String> view, boolean failed) {
        double[] areas = new double[in.length + 1];
        for (int chip = 0; chip < game.bodies().size(); chip++) {
            double radius = game.bodies().radius[chip];
            double area = radius * radius * Math.PI;
            areas[in.length] += area;
            if (game.ownerOf(chip) != ChipTable.NEUTRAL) {
                areas[game.ownerOf(chip)] += area;
            }
        }
        view.add(failed ? REST : Arrays.stream(areas).mapToObj(area -> decimal(area, AREA))
            .collect(Collectors.joining(" ")));
        view.add(failed ? REST : IntStream.range(0, in.length).mapToObj(player -> "" + game.score(player))
            .collect(Collectors.joining(" ")));
    }

    /** Of players who are in, the score. */
    private List<String> summary() {
        return IntStream.range(0, in.length).mapToObj(player -> "$" + player
            + (!game.isIn(player) || anyFailed ? " " + REST : " score: " + game.score(player))).toList();
    }

    /** Halves of the shortest decimal away from zero, as the server writes them. */
    private static String decimal(double value, int digits) {
        return new BigDecimal(NumberOutput.toString(value, true)).setScale(digits, RoundingMode.HALF_UP)
            .toPlainString();
    }
}
