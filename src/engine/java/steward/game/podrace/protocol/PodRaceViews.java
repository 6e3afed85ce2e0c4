package steward.game.podrace.protocol;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.stream.IntStream;
import steward.game.Game;
import steward.game.ShownMessages;
import steward.game.ViewWriter;
import steward.game.podrace.Headings;
import steward.game.podrace.PodRace;
import steward.game.podrace.PodRaceSettings;
import steward.physics.Impact;

/**
 * Writer of the server's views for a race of two players with two pods each:
 * <pre>
 * line 0      the number of the frame, perhaps with words around it
 * frame 0     CodersStrikeBack
 *             width height podRadius checkpointRadius pods turnPerTurn
 *             x y x y ...                                            the checkpoints
 *             player x y player x y ...                              where the pods start
 * a pod       x y vx vy power dead targetX targetY headingRadians|null shield nextCheckpoint rank
 *             "message"
 * then        rank:turnsLeft rank:turnsLeft                          both players on one line
 * per impact  id time podA xA yA podB xB yB impulse vx vy
 * </pre>
 * Places of impacts are rounded; their vx, vy are half the sum of both speeds before the impact, rounded. A player who
 * fails has empty messages, and if it was late, its frame has a tooltip. A view may end before its pods or before its
 * counters. Sources: games of 2025 and 2026, among them ten that ended by a fault, a finish or an elimination. If they
 * do not show something, the published referee decides: a pod that was told to aim at its own place shows the thrust
 * that it was given.
 */
final class PodRaceViews implements ViewWriter {

    private static final int FIELD_WIDTH = 16000;
    private static final int FIELD_HEIGHT = 9000;
    private static final int LONGEST_MESSAGE = 50;
    /** Lines of a view after a turn before those of the pods, two a pod. */
    private static final int BEFORE_PODS = 1;
    /** Likewise of the first view; the last of them has their places. */
    private static final int BEFORE_PODS_OF_START = 5;

    private PodRace race;
    private int[] thrust;
    private boolean[] shield;
    private boolean[] boostLeft;
    private boolean started;
    private boolean[] failed;

    @Override
    public List<String> notCompared() {
        return List.of("gameInformation of a player who fails, tooltips but those of timeouts, texts in colour",
            "numbers of impacts");
    }

    @Override
    public void begin(Game game) {
        race = (PodRace) game;
        int pods = race.settings().pods();
        thrust = new int[pods];
        shield = new boolean[pods];
        boostLeft = new boolean[pods];
        failed = new boolean[race.players()];
    }

    @Override
    public boolean mayEndAt(int line) {
        int pods = started ? BEFORE_PODS : BEFORE_PODS_OF_START;
        return line == pods || line == pods + 2 * race.settings().pods() || !started && line == pods - 1;
    }

    @Override
    public Frame start() {
        List<String> view = new ArrayList<>(List.of(ANY, PodRaceView.TITLE));
        view.add(FIELD_WIDTH + " " + FIELD_HEIGHT + " " + race.settings().radius() + " "
            + race.settings().checkpointRadius() + " " + race.settings().pods() + " " + Headings.MAXIMUM_TURN);
        StringBuilder line = new StringBuilder();
        for (double[] checkpoint : race.checkpoints()) {
            line.append(checkpoint[0]).append(' ').append(checkpoint[1]).append(' ');
        }
        view.add(line.toString());
        line.setLength(0);
        for (int pod = 0; pod < race.settings().pods(); pod++) {
            line.append(race.playerOf(pod)).append(' ').append(race.bodies().x[pod]).append(' ')
                .append(race.bodies().y[pod]).append(' ');
        }
        view.add(line.toString());
        int[] first = new int[race.settings().pods()];
        for (int pod = 0; pod < first.length; pod++) {
            view.add(place(pod) + " 0 0 null null null 0 " + race.nextCheckpoint(pod) + " 1");
            view.add("\"\"");
        }
        view.add(counters(first));
        return new Frame(view, summary(first));
    }

    @Override
    public void before() {
        started = true;
        for (int player = 0; player < failed.length; player++) {
            failed[player] = !race.isIn(player);
        }
        for (int pod = 0; pod < thrust.length; pod++) {
            thrust[pod] = race.thrust(pod);
            boostLeft[pod] = race.boostLeft(pod);
            shield[pod] = thrust[pod] == PodRace.NO_COMMAND ? shield[pod] : thrust[pod] == PodRace.SHIELD;
        }
    }

    @Override
    public Frame after(String[] messages, List<String> shown) {
        boolean finished = IntStream.range(0, thrust.length).anyMatch(this::hasFinished);
        boolean ends = race.isOver() && (finished || race.turn() >= race.settings().maximumTurns());
        List<String> view = new ArrayList<>();
        view.add(ANY + " " + (finished ? "endReached" : ends ? "maxRoundsCountReached" : ""));
        int[] ranks = podRanks();
        ShownMessages said = null;
        for (int pod = 0; pod < thrust.length; pod++) {
            int player = race.playerOf(pod);
            boolean first = pod == 0 || race.playerOf(pod - 1) != player;
            said = first ? new ShownMessages(messages[player], LONGEST_MESSAGE, LONGEST_MESSAGE, "...") : said;
            boolean commanded = thrust[pod] != PodRace.NO_COMMAND;
            double heading = race.heading(pod);
            view.add(place(pod) + " " + power(pod) + " " + (race.isIn(player) ? 0 : 1) + " "
                + (commanded ? race.targetX(pod) + " " + race.targetY(pod) : "null null") + " "
                + (Double.isNaN(heading) ? "null" : heading) + " " + (shield[pod] ? 1 : 0) + " "
                + race.nextCheckpoint(pod) + " " + (ranks[pod] + 1));
            int line = view.size();
            String text = line < shown.size() ? shown.get(line).strip().replaceAll("^\"|\"$", "") : "";
            boolean last = pod == thrust.length - 1 || race.playerOf(pod + 1) != player;
            String blanks = text.substring(text.stripTrailing().length());
            view.add(failed[player] ? "\"\"" : "\"" + said.next(text, last) + blanks + "\"");
        }
        view.add(counters(ranks));
        for (int k = 0; k < race.log().kept(); k++) {
            view.add(impact(race.log().impact(k)));
        }
        List<String> summary = new ArrayList<>(summary(ranks));
        if (ends) {
            summary.add(REST);
        }
        return new Frame(view, summary, information(race.players() - 1), tooltips(race.players() - 1));
    }

    @Override
    public Frame answer(int answer) {
        return new Frame(List.of(ANY + " " + REST), null, information(answer), tooltips(answer));
    }

    /** Sentences on what the pods of a player do; {@code null} for one who fails. A second boost has usual power. */
    private List<String> information(int player) {
        if (player >= failed.length || failed[player]) {
            return null;
        }
        int each = race.settings().podsPerPlayer();
        return IntStream.range(0, each).mapToObj(k -> "Pod " + (k + 1) + " of player $" + player + " "
            + does(player * each + k)).toList();
    }

    private String does(int pod) {
        String towards = " towards (" + whole(race.targetX(pod)) + ", " + whole(race.targetY(pod)) + ")";
        return thrust[pod] == PodRace.SHIELD ? "enabled its shield"
            : race.shieldTimer(pod) != 0 ? "waits for its engine to reload"
            : thrust[pod] == PodRace.BOOST && boostLeft[pod] ? "boosts" + towards
            : "moves" + towards + " at power " + power(pod);
    }

    private static String whole(double coordinate) {
        return coordinate == Math.rint(coordinate) ? Long.toString((long) coordinate) : Double.toString(coordinate);
    }

    /** Tooltips of the frame of a player; {@code null} but for one whose answer was missing. */
    private List<String> tooltips(int player) {
        return player < failed.length && failed[player] && NO_ANSWER.equals(race.eliminationReason(player))
            ? List.of(player + " $" + player + ": timeout!") : null;
    }

    private String place(int pod) {
        return race.bodies().x[pod] + " " + race.bodies().y[pod] + " " + race.bodies().vx[pod] + " "
            + race.bodies().vy[pod];
    }

    /** The thrust that a pod was told, as far as it has any. */
    private int power(int pod) {
        if (thrust[pod] == PodRace.NO_COMMAND || race.shieldTimer(pod) != 0) {
            return 0;
        }
        return thrust[pod] != PodRace.BOOST ? thrust[pod]
            : boostLeft[pod] ? PodRaceSettings.BOOST_THRUST : race.settings().maximumThrust();
    }

    private boolean hasFinished(int pod) {
        return race.passed(pod) >= race.settings().laps() * race.checkpoints().length;
    }

    /** Per pod how many ranks are before its own; pods of players who are out come last, pods that tie share one. */
    private int[] podRanks() {
        List<Integer> order = new ArrayList<>(IntStream.range(0, thrust.length).boxed().toList());
        Collections.sort(order, this::compare);
        int[] ranks = new int[thrust.length];
        for (int k = 1; k < order.size(); k++) {
            int before = order.get(k - 1);
            ranks[order.get(k)] = ranks[before] + (compare(before, order.get(k)) < 0 ? 1 : 0);
        }
        return ranks;
    }

    private int compare(int one, int other) {
        boolean in = race.isIn(race.playerOf(one));
        if (in != race.isIn(race.playerOf(other))) {
            return in ? -1 : 1;
        }
        int passed = Integer.compare(race.passed(other), race.passed(one));
        return passed != 0 ? passed : Double.compare(race.toNext(one), race.toNext(other));
    }

    /** Per player how many others have a better best pod, counted without gaps. */
    private int[] ranks(int... podRanks) {
        int[] best = new int[race.players()];
        for (int player = 0; player < best.length; player++) {
            int each = race.settings().podsPerPlayer();
            best[player] = IntStream.range(player * each, (player + 1) * each).map(pod -> podRanks[pod]).min()
                .orElseThrow();
        }
        return IntStream.of(best).map(own -> (int) IntStream.of(best).filter(other -> other < own).distinct().count())
            .toArray();
    }

    /** The server counts on for a player who fails. */
    private String counters(int... podRanks) {
        int[] ranks = ranks(podRanks);
        StringBuilder line = new StringBuilder();
        for (int player = 0; player < ranks.length; player++) {
            int left = race.turnsLeft(player) - (failed[player] ? 1 : 0);
            line.append(ranks[player] + 1).append(':').append(left).append(' ');
        }
        return line.toString();
    }

    private List<String> summary(int... podRanks) {
        int[] ranks = ranks(podRanks);
        return IntStream.range(0, ranks.length).mapToObj(player -> "$" + player
            + (race.isIn(player) ? "" : " eliminated!") + " rank: " + (ranks[player] + 1)).toList();
    }

    /** The server's sines may be a unit in the last place off, so that time and impulse need only be near. */
    private static String impact(Impact impact) {
        return ANY + " " + NEAR + impact.time() + " " + impact.a() + " " + Math.round(impact.ax()) + " "
            + Math.round(impact.ay()) + " " + impact.b() + " " + Math.round(impact.bx()) + " "
            + Math.round(impact.by()) + " " + NEAR + impact.impulse() + " "
            + Math.round((impact.vaxBefore() + impact.vbxBefore()) / 2) + " "
            + Math.round((impact.vayBefore() + impact.vbyBefore()) / 2);
    }

    /** One who is out has none; of the others each has one for every player whom he is not behind, and no less. */
    @Override
    public double[] scores() {
        int[] ranks = ranks(podRanks());
        return IntStream.range(0, ranks.length)
            .mapToDouble(player -> race.isIn(player) ? ranks.length - ranks[player] : 0).toArray();
    }
}
