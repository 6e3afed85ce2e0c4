package steward.cli.play;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.io.Writer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.function.ToDoubleFunction;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import steward.cli.shared.Games;
import steward.files.InputException;
import steward.files.OutputFiles;
import steward.game.Game;
import steward.game.GameJson;
import steward.game.GameSetup;
import steward.match.MatchListener;
import steward.match.Turn;
import steward.physics.Bodies;
import steward.physics.Forces;
import steward.physics.TeeSink;
import steward.physics.TurnSink;
import tools.jackson.core.io.NumberOutput;

/**
 * Tables of a run without players, turn by turn: energy, momenta, temperature, pressure and impacts. They are text for
 * people and CSV; all states and impacts can be added as CSV. The field {@code csv} of a scene reads such a table of
 * states. Rows are written turn by turn, so that all files end with the same turn whenever any thread closes them.
 */
final class RunTables implements MatchListener, AutoCloseable {

    /** Rows of the table for people, at most. */
    private static final int MOST_ROWS = 12;

    private static final String STATES = "turn,id,x [u],y [u],vx [u/turn],vy [u/turn],radius [u],mass [m],restitution,"
        + "drag [1/turn]\n";
    private static final String IMPACTS = "turn,time [turn],a,b,wall,ax [u],ay [u],bx [u],by [u],impulse [m u/turn],"
        + "energy [m u^2/turn^2],normalX,normalY,vaxBefore [u/turn],vayBefore [u/turn],vaxAfter [u/turn],"
        + "vayAfter [u/turn],vbxBefore [u/turn],vbyBefore [u/turn],vbxAfter [u/turn],vbyAfter [u/turn]\n";

    private final Table turns;
    private final Table states;
    private final Table impacts;
    private boolean closed;
    private final List<TurnRow> rows = new ArrayList<>();
    private Game game;
    private Runnable step = () -> { };
    private int impactsOfTurn;
    /** Impulses on walls, bumpers and other infinite masses in the turn. */
    private double pushOfTurn;
    /** Impulses times distances of centres, or radii where one has infinite mass. */
    private double virialOfTurn;
    /** Energy that rest took in the turn. */
    private double restOfTurn;
    /** When the turn reached the bound on impacts; NaN if it did not. */
    private double limitTime = Double.NaN;
    private Forces forces = Forces.NONE;
    private Enclosure enclosure = Enclosure.NONE;
    /** The id of the first bumper: as many bodies come from the scene's lists and fills. */
    private int bumpers;
    /** Places before the first turn, by id. */
    private double[] startX;
    private double[] startY;

    /** A file, and its rows of the turn that is played. */
    private record Table(Writer file, StringBuilder rows) { }

    private RunTables(Table turns, Table states, Table impacts) {
        this.turns = turns;
        this.states = states;
        this.impacts = impacts;
    }

    /** @param folder for the files, or {@code null} for none */
    static RunTables open(Path folder, boolean overwrite) {
        if (folder == null) {
            return new RunTables(null, null, null);
        }
        OutputFiles.prepareFolder(folder);
        List.of("turns.csv", "states.csv", "impacts.csv")
            .forEach(name -> OutputFiles.check(folder.resolve(name), overwrite));
        try {
            return new RunTables(file(folder, "turns.csv", TurnRow.COLUMNS.csv(List.of(), RunTables::number, false)),
                file(folder, "states.csv", STATES), file(folder, "impacts.csv", IMPACTS));
        } catch (IOException problem) {
            throw new InputException(folder + ": cannot be written into: " + OutputFiles.reason(folder, problem));
        }
    }

    private static Table file(Path folder, String name, String columns) throws IOException {
        Writer file = Files.newBufferedWriter(folder.resolve(name));
        file.write(columns);
        return new Table(file, new StringBuilder());
    }

    /** Returns the setup with all impacts of its games told to these tables: a game's log keeps the first only. */
    GameSetup watching(GameSetup setup) {
        TurnSink watcher = new TurnSink() {
            @Override
            public void impact(double time, int a, int b, double ax, double ay, double bx, double by,
                               double normalX, double normalY, double impulse, double energy, double massA,
                               double massB, double vaxBefore, double vayBefore, double vaxAfter, double vayAfter,
                               double vbxBefore, double vbyBefore, double vbxAfter, double vbyAfter) {
                impactsOfTurn++;
                boolean isHeld = massA == Double.POSITIVE_INFINITY || massB == Double.POSITIVE_INFINITY;
                pushOfTurn += isHeld ? impulse : 0;
                virialOfTurn += impulse * (!isHeld ? Math.sqrt((bx - ax) * (bx - ax) + (by - ay) * (by - ay))
                    : radius(massA == Double.POSITIVE_INFINITY ? b : a));
                if (impacts != null) {
                    impacts.rows.append(game.turn() + "," + number(time) + "," + a + "," + (b < 0 ? "," + ~b : b + ",")
                        + cells(ax, ay, bx, by, impulse, energy, normalX, normalY, vaxBefore, vayBefore, vaxAfter,
                        vayAfter, vbxBefore, vbyBefore, vbxAfter, vbyAfter) + "\n");
                }
            }

            @Override
            public void rest(double time, double energy) {
                restOfTurn += energy;
            }

            @Override
            public void impactLimit(double time, int[] bodyIds) {
                limitTime = time;
            }
        };
        setup.scene().field().ifPresent(field -> enclosure = Enclosure.of(field));
        bumpers = -setup.scene().field().map(field -> field.bumpers().size()).orElse(0);
        return Games.types().open(setup.scene().withObserver((parts, advance) -> {
            forces = parts.forces();
            return (bodies, sink) -> advance.turn(bodies, new TeeSink(sink, watcher));
        }));
    }

    /** @param everyTurn is called after each turn */
    MatchListener following(Runnable everyTurn) {
        step = everyTurn;
        return this;
    }

    /** Returns how many bodies that can move are at rest, as a text; {@code ""} where none can come to rest. */
    String standing() {
        int resting = game.bodiesAtRest();
        Bodies bodies = game.bodies();
        long count = IntStream.range(0, bodies.size()).filter(k -> bodies.inverseMass[k] > 0).count();
        return resting < 0 ? "" : resting + " of " + count + " at rest";
    }

    private double radius(int id) {
        return game.bodies().radius[game.bodies().indexOf(id)];
    }

    @Override
    public void start(Game started, GameJson codec) {
        game = started;
        Bodies bodies = started.bodies();
        bumpers += bodies.size();
        startX = Arrays.copyOf(bodies.x, bodies.size());
        startY = Arrays.copyOf(bodies.y, bodies.size());
        add();
    }

    @Override
    public void played(Turn turn) {
        add();
        step.run();
    }

    /** Adds a row. The speed at the end of a turn is v + a / 2, since v is that of the middle of a parabola. */
    private void add() {
        Bodies bodies = game.bodies();
        double energy = 0;
        double potential = 0;
        double momentumX = 0;
        double momentumY = 0;
        double angularMomentum = 0;
        int count = 0;
        for (int k = 0; k < bodies.size(); k++) {
            double mass = bodies.mass[k];
            double vx = bodies.vx[k];
            double vy = bodies.vy[k];
            if (bodies.inverseMass[k] > 0) {
                double ax = forces.x(bodies, k);
                double ay = forces.y(bodies, k);
                int id = bodies.id(k);
                energy += mass * ((vx + ax / 2) * (vx + ax / 2) + (vy + ay / 2) * (vy + ay / 2)) / 2;
                potential -= mass * (ax * (bodies.x[k] - startX[id]) + ay * (bodies.y[k] - startY[id]));
                momentumX += mass * vx;
                momentumY += mass * vy;
                angularMomentum += mass * (bodies.x[k] * vy - bodies.y[k] * vx);
                count++;
            }
            if (states != null && bodies.id(k) < bumpers) {
                states.rows.append(game.turn() + "," + bodies.id(k) + cells(bodies.x[k], bodies.y[k], vx, vy,
                    bodies.radius[k]) + "," + (bodies.inverseMass[k] > 0 ? number(mass) : "infinite")
                    + cells(bodies.restitution[k], bodies.drag[k]) + "\n");
            }
        }
        boolean isPlayed = !rows.isEmpty();
        rows.add(new TurnRow(game.turn(), energy, momentumX, momentumY, impactsOfTurn, potential + 0.0, limitTime,
            restOfTurn, restOfTurn + (isPlayed ? rows.get(rows.size() - 1).restSum() : 0), angularMomentum,
            count == 0 ? Double.NaN : energy / count, isPlayed ? pushOfTurn / enclosure.length() : Double.NaN,
            isPlayed && !forces.act() ? (energy + virialOfTurn / 2) / enclosure.area() : Double.NaN));
        impactsOfTurn = 0;
        pushOfTurn = 0;
        virialOfTurn = 0;
        restOfTurn = 0;
        limitTime = Double.NaN;
        if (turns != null) {
            turns.rows.append(TurnRow.COLUMNS.csvRows(rows.subList(rows.size() - 1, rows.size()), RunTables::number,
                false));
            write(false);
        }
    }

    /** The table for people: some turns, evenly, the first and the last among them. */
    List<String> lines() {
        List<String> lines = new ArrayList<>();
        boolean byWalls = !Double.isNaN(enclosure.length());
        boolean byVirial = !Double.isNaN(enclosure.area()) && !forces.act();
        lines.add(String.format(Locale.ROOT, "%7s%s%s%s%s%s%s%s%s  %9s", "turn", word("energy"),
            forces.act() ? word("potential") : "", word("momentum x"), word("momentum y"), word("angular m."),
            word("temperature"), byWalls ? word("p, walls") : "", byVirial ? word("p, virial") : "", "impacts"));
        int shown = Math.min(MOST_ROWS, rows.size());
        int from = 0;
        for (int k = 0; k < shown; k++) {
            int to = shown == 1 ? 0 : (int) ((long) k * (rows.size() - 1) / (shown - 1));
            List<TurnRow> since = rows.subList(from, to + 1);
            TurnRow row = rows.get(to);
            lines.add(String.format(Locale.ROOT, "%7d%s%s%s%s%s%s%s%s  %9d", row.turn(), word(row.energy()),
                forces.act() ? word(row.potential()) : "", word(row.momentumX()), word(row.momentumY()),
                word(row.angularMomentum()), word(row.temperature()),
                byWalls ? word(mean(since, TurnRow::pressureWalls)) : "",
                byVirial ? word(mean(since, TurnRow::pressureVirial)) : "",
                since.stream().mapToLong(TurnRow::impacts).sum()));
            from = to + 1;
        }
        if (rows.size() > shown) {
            lines.add("Impacts" + (byWalls || byVirial ? " and the mean pressure" : "")
                + " are those since the row before. All turns: --csv.");
        }
        double rest = rows.isEmpty() ? 0 : rows.get(rows.size() - 1).restSum();
        if (rest != 0) {
            double share = 0;
            for (int k = 1; k < rows.size(); k++) {
                share = Math.max(share, rows.get(k).rest() / rows.get(k - 1).energy());
            }
            lines.add(String.format(Locale.ROOT, "Rest took the energy %.3g, at most %.1e of that at the start of a "
                + "turn.", rest, share));
        }
        List<TurnRow> limited = rows.stream().filter(TurnRow::isLimited).toList();
        if (!limited.isEmpty()) {
            lines.add(String.format(Locale.ROOT, "%d of %d turns reached the bound on impacts, the first of them turn "
                + "%d: there bodies in contact kept their places.", limited.size(), rows.size() - 1,
                limited.get(0).turn()));
        }
        return lines;
    }

    private static String word(String text) {
        return String.format("  %12s", text);
    }

    private static String word(double value) {
        return Double.isNaN(value) ? word("") : String.format(Locale.ROOT, "  %12.6g", value);
    }

    private static double mean(List<TurnRow> of, ToDoubleFunction<TurnRow> value) {
        return of.stream().mapToDouble(value).average().orElse(Double.NaN);
    }

    Iterable<Object> json() {
        return TurnRow.COLUMNS.json(rows);
    }

    /** Numbers with a comma before each, nothing behind it for NaN. */
    private static String cells(double... values) {
        return Arrays.stream(values).mapToObj(value -> "," + (Double.isNaN(value) ? "" : number(value)))
            .collect(Collectors.joining());
    }

    private static String number(double value) {
        return NumberOutput.toString(value, true);
    }

    /** Writes the rows of a turn, or ends the files; nothing is written behind their end. */
    private synchronized void write(boolean last) {
        try {
            for (Table table : turns == null || closed ? new Table[0] : new Table[] {turns, states, impacts}) {
                if (last) {
                    table.file.close();
                } else {
                    table.file.append(table.rows);
                    table.rows.setLength(0);
                }
            }
            closed |= last;
        } catch (IOException problem) {
            throw new UncheckedIOException("a table cannot be written: " + problem.getMessage(), problem);
        }
    }

    @Override
    public void close() {
        write(true);
    }
}
