package steward.game.searchrace.protocol;

import java.text.DecimalFormat;
import java.text.DecimalFormatSymbols;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import steward.game.Game;
import steward.game.TurnEvent;
import steward.game.ViewWriter;
import steward.game.searchrace.OfficialSearchRace;
import steward.game.searchrace.SearchRace;
import steward.numerics.StrictAngles;

/**
 * Writer of views of the search race as the server shows them, as {@link GraphicsLines}. Places are in pixels, angles
 * in whole degrees cut off, scales have six digits; each value is written the first time and when it changes. The form
 * is that of the published referee, Illedan/CGSearchRace, with the site's toolkit, as its demonstration shows it; no
 * game of the server itself was at hand. Entities are numbered as the referee makes them. The tooltips have whole
 * places; a race that is finished is declared so in one more frame, in which nobody is asked.
 */
final class SearchRaceViews implements ViewWriter {

    private static final int CAR = 6;
    private static final int LAST_PLACE = 3;
    private static final int CAR_PLACE = 4;
    private static final int ARROW = 5;
    private static final int EXHAUST = 8;
    private static final double PIXELS = 1920 / 16_000.0;
    private static final double QUARTER = Math.PI / 2;
    private static final double LOST = 1000;
    /** The end of a turn. */
    private static final String LATE = "1";

    private SearchRace race;
    private Entities entities;
    private final Map<String, Object> values = new TreeMap<>();
    private final Map<String, List<String>> updates = new TreeMap<>();
    private final List<String> lines = new ArrayList<>();
    private final DecimalFormat six = new DecimalFormat("0.######", DecimalFormatSymbols.getInstance(Locale.ROOT));
    private double[] before;
    private int thrust;
    private int marked;

    /** The numbers of the entities of a map. */
    private record Entities(int checkpoints) {

        int circle(int checkpoint) {
            return 10 + 2 * checkpoint;
        }

        int label(int checkpoint) {
            return 11 + 2 * checkpoint;
        }

        int timer() {
            return 10 + 2 * checkpoints;
        }

        int message() {
            return timer() + 1;
        }

        int target() {
            return timer() + 2;
        }

        /** The attributes that say how the race stands; {@code null} for an entity that does not. */
        Set<String> kept(int id) {
            if (id >= 10 && id < timer()) {
                return id % 2 == 0 ? Set.of("x", "y", "R") : Set.of("x", "y", "T");
            }
            return switch (id) {
                case LAST_PLACE, CAR_PLACE -> Set.of("x", "y");
                case ARROW, CAR -> Set.of("r");
                case EXHAUST -> Set.of("sx", "sy");
                default -> id >= timer() && id <= target() ? Set.of("T") : null;
            };
        }
    }

    @Override
    public List<String> notCompared() {
        return List.of("gameInformation, tooltips of the site", "colours, images and sizes",
            "skid marks and lines that are hidden", "of the frame that declares a finish all but the time", "scores");
    }

    @Override
    public List<String> lines(String text) {
        return GraphicsLines.of(text, entities::kept);
    }

    @Override
    public void begin(Game of) {
        race = (SearchRace) of;
        entities = new Entities(race.checkpoints().length);
    }

    @Override
    public Frame start() {
        double[][] checkpoints = race.checkpoints();
        for (int k = 0; k < checkpoints.length; k++) {
            String circle = entities.circle(k) + " 0";
            putPlace(circle, checkpoints[k][0], checkpoints[k][1]);
            put(circle, "R", Long.toString(pixels(race.settings().checkpointRadius())));
            String label = entities.label(k) + " " + LATE;
            putPlace(label, checkpoints[k][0], checkpoints[k][1]);
            put(label, "T", Integer.toString(k));
            lines.add(GraphicsLines.TOOLTIP + entities.circle(k) + " Checkpoint x = " + (int) checkpoints[k][0]
                + " y = " + (int) checkpoints[k][1]);
        }
        before = new double[] {race.bodies().x[0], race.bodies().y[0]};
        putPlace(LAST_PLACE + " " + LATE, before[0], before[1]);
        putPlace(CAR_PLACE + " " + LATE, before[0], before[1]);
        put(ARROW + " " + LATE, "r", QUARTER, degrees(QUARTER));
        put(CAR + " 0", "r", race.heading() + QUARTER, degrees(race.heading() + QUARTER));
        putScale(EXHAUST + " " + LATE, 0.0);
        put(entities.timer() + " " + LATE, "T", "0");
        put(entities.message() + " " + LATE, "T", "");
        put(entities.target() + " " + LATE, "T", "1");
        return frame();
    }

    @Override
    public void before() {
        before = new double[] {race.bodies().x[0], race.bodies().y[0]};
        thrust = race.thrust();
    }

    @Override
    public Frame after(String[] messages, List<String> shown) {
        if (race.isIn(0)) {
            double x = race.bodies().x[0];
            double y = race.bodies().y[0];
            double vx = race.bodies().vx[0];
            double vy = race.bodies().vy[0];
            putPlace(LAST_PLACE + " " + LATE, before[0], before[1]);
            put(entities.message() + " " + LATE, "T", quoted(messages[0] == null ? "" : messages[0]));
            updates.put(EXHAUST + " 0", new ArrayList<>());
            putScale(EXHAUST + " 0", (thrust + 50) / 200.0);
            putPlace(CAR_PLACE + " " + LATE, x, y);
            if (x != before[0] || y != before[1] || race.turn() == 1) {
                lines.add(GraphicsLines.TOOLTIP + CAR + " Car x = " + (int) x + " y = " + (int) y);
            }
            put(CAR + " " + LATE, "r", race.heading() + QUARTER, degrees(race.heading() + QUARTER));
            put(entities.timer() + " " + LATE, "T", Integer.toString(race.timer()));
            mark(race.nextCheckpoint());
            double course = StrictAngles.atan2(vy, vx);
            put(ARROW + " " + LATE, "r", course, degrees(course));
        }
        if (race.isOver() && race.scores()[0] == LOST) {
            lines.add(GraphicsLines.END + (int) LOST + " " + LOST);
        }
        return frame();
    }

    @Override
    public List<String> declared() {
        double time = race.scores()[0];
        return List.of(ANY + " " + REST, GraphicsLines.END + (int) time + " " + time, REST);
    }

    /** The time of a race that is over is in {@link #declared}. */
    @Override
    public double[] scores() {
        return new double[0];
    }

    /** The checkpoint to be passed next is lit when the last one was passed. */
    private void mark(int next) {
        if (next == marked) {
            return;
        }
        String time = six.format(Math.min(1.0, race.passTime()));
        boolean late = time.equals(LATE);
        updates.computeIfAbsent(entities.circle(next) + " " + time, none -> new ArrayList<>());
        if (!late) {
            updates.computeIfAbsent(entities.circle(marked) + " " + time, none -> new ArrayList<>());
        }
        marked = next;
        put(entities.target() + " " + LATE, "T", "'" + next + " (" + race.passed() + ")'");
    }

    /** Takes the lines of a frame; line 0 is its number. */
    private Frame frame() {
        updates.forEach((idAndTime, attributes) -> lines.add(GraphicsLines.update(idAndTime, attributes)));
        lines.sort(null);
        lines.add(0, ANY + " " + REST);
        Frame frame = new Frame(List.copyOf(lines), summary());
        updates.clear();
        lines.clear();
        return frame;
    }

    /** The times of all checkpoints passed in the turn; what a player has done wrong is said in the server's words. */
    private List<String> summary() {
        List<String> summary = new ArrayList<>();
        for (TurnEvent event : race.events()) {
            if (event.kind() == TurnEvent.Kind.MARK) {
                summary.add("Collision Time: " + event.time());
            }
        }
        if (!race.isIn(0)) {
            summary.add(REST);
        }
        return summary;
    }

    private void putPlace(String idAndTime, double x, double y) {
        put(idAndTime, "x", Long.toString(pixels(x)));
        put(idAndTime, "y", Long.toString(pixels(y)));
    }

    private void putScale(String idAndTime, double scale) {
        put(idAndTime, "sx", scale, six.format(scale));
        put(idAndTime, "sy", scale, six.format(scale));
    }

    private void put(String idAndTime, String key, String value) {
        put(idAndTime, key, value, value);
    }

    /** Keeps a value, and tells it if it has changed, be it in digits that are not shown. */
    private void put(String idAndTime, String key, Object value, String shown) {
        if (!value.equals(values.put(idAndTime.split(" ")[0] + key, value))) {
            updates.computeIfAbsent(idAndTime, none -> new ArrayList<>()).add(key + " " + shown);
        }
    }

    private static long pixels(double place) {
        return Math.round(place * PIXELS);
    }

    private static String degrees(double radians) {
        return Integer.toString((int) (radians * OfficialSearchRace.DEGREES));
    }

    private static String quoted(String text) {
        return text.matches("(?s).*[ ;\n'].*") ? "'" + text.replace("'", "\\'") + "'" : text;
    }
}
