package steward.cli.play;

import java.io.BufferedWriter;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import steward.cli.shared.Games;
import steward.files.InputException;
import steward.files.OutputFiles;
import steward.game.FrameCodec;
import steward.game.Game;
import steward.game.GameSetup;
import steward.json.JsonNumbers;
import steward.json.JsonObject;
import steward.match.MatchListener;
import steward.match.Turn;
import steward.physics.Bodies;
import steward.physics.Forces;
import steward.physics.TeeSink;
import steward.physics.TurnSink;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.io.NumberOutput;

/** Energy, momentum and impacts of every turn, for people and as CSV; with every state and every impact as CSV. */
final class RunTables implements MatchListener, AutoCloseable {

    /** Rows of the table for people, at most. */
    private static final int MOST_ROWS = 12;

    private final BufferedWriter turns;
    private final BufferedWriter states;
    private final BufferedWriter impacts;
    private final List<double[]> rows = new ArrayList<>();
    private Game game;
    private Runnable step = () -> { };
    private int impactsOfTurn;
    /** Energy that rest took in the turn. */
    private double restOfTurn;
    /** When the turn reached the bound on impacts; NaN if it did not. */
    private double limitTime = Double.NaN;
    private Forces forces = Forces.NONE;
    /** Of all bodies by the forces, before the first turn. */
    private double start;

    private RunTables(BufferedWriter turns, BufferedWriter states, BufferedWriter impacts) {
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
            return new RunTables(file(folder, "turns.csv",
                "turn,energy,momentumX,momentumY,impacts,potential,limitTime,rest,restSum"),
                file(folder, "states.csv", "turn,id,x,y,vx,vy"),
                file(folder, "impacts.csv", "turn,time,a,b,wall,ax,ay,bx,by,impulse,energy"));
        } catch (IOException problem) {
            throw new InputException(folder + ": cannot be written into: " + OutputFiles.reason(folder, problem));
        }
    }

    private static BufferedWriter file(Path folder, String name, String columns) throws IOException {
        BufferedWriter file = Files.newBufferedWriter(folder.resolve(name));
        file.write(columns + "\n");
        return file;
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
                if (impacts != null) {
                    write(impacts, game.turn() + "," + number(time) + "," + a + "," + (b < 0 ? "," + ~b : b + ",")
                        + cells(ax, ay, bx, by, impulse, energy));
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

    @Override
    public void start(Game started, FrameCodec codec) {
        game = started;
        start = potential(started.bodies());
        add();
    }

    @Override
    public void played(Turn turn) {
        add();
        step.run();
    }

    /** The energy that the forces give: minus the force times the place. */
    private double potential(Bodies bodies) {
        double sum = 0;
        for (int k = 0; k < bodies.size() && forces.act(); k++) {
            if (bodies.inverseMass[k] > 0) {
                sum -= bodies.mass[k] * (forces.x(bodies, k) * bodies.x[k] + forces.y(bodies, k) * bodies.y[k]);
            }
        }
        return sum;
    }

    /** Adds a row. The speed at the end of a turn is v + a / 2, since v is that of the middle of a parabola. */
    private void add() {
        Bodies bodies = game.bodies();
        double[] row = {game.turn(), 0, 0, 0, impactsOfTurn, potential(bodies) - start, limitTime, restOfTurn,
            restOfTurn + (rows.isEmpty() ? 0 : rows.get(rows.size() - 1)[8])};
        impactsOfTurn = 0;
        restOfTurn = 0;
        limitTime = Double.NaN;
        for (int k = 0; k < bodies.size(); k++) {
            if (bodies.inverseMass[k] > 0) {
                double vx = bodies.vx[k] + forces.x(bodies, k) / 2;
                double vy = bodies.vy[k] + forces.y(bodies, k) / 2;
                row[1] += bodies.mass[k] * (vx * vx + vy * vy) / 2;
                row[2] += bodies.mass[k] * bodies.vx[k];
                row[3] += bodies.mass[k] * bodies.vy[k];
            }
            if (states != null) {
                write(states, game.turn() + "," + bodies.id(k)
                    + cells(bodies.x[k], bodies.y[k], bodies.vx[k], bodies.vy[k]));
            }
        }
        rows.add(row);
        if (turns != null) {
            write(turns, (int) row[0] + cells(row[1], row[2], row[3]).stripTrailing() + "," + (int) row[4]
                + cells(row[5]).stripTrailing() + "," + (Double.isNaN(row[6]) ? "" : number(row[6]))
                + cells(row[7], row[8]));
        }
    }

    /** The table for people: some turns, evenly, the first and the last among them. */
    List<String> lines() {
        List<String> lines = new ArrayList<>();
        lines.add(String.format(Locale.ROOT, "%7s  %14s%s  %14s  %14s  %9s", "turn", "energy",
            forces.act() ? String.format("  %14s", "potential") : "", "momentum x", "momentum y", "impacts"));
        int shown = Math.min(MOST_ROWS, rows.size());
        int from = 0;
        for (int k = 0; k < shown; k++) {
            int to = shown == 1 ? 0 : (int) ((long) k * (rows.size() - 1) / (shown - 1));
            long sum = 0;
            for (int turn = from; turn <= to; turn++) {
                sum += (long) rows.get(turn)[4];
            }
            double[] row = rows.get(to);
            lines.add(String.format(Locale.ROOT, "%7d  %14.7g%s  %14.7g  %14.7g  %9d", (int) row[0], row[1],
                forces.act() ? String.format(Locale.ROOT, "  %14.7g", row[5]) : "", row[2], row[3], sum));
            from = to + 1;
        }
        if (rows.size() > shown) {
            lines.add("Impacts are those since the row before. All turns: --csv.");
        }
        double rest = rows.isEmpty() ? 0 : rows.get(rows.size() - 1)[8];
        if (rest != 0) {
            double share = 0;
            for (int k = 1; k < rows.size(); k++) {
                share = Math.max(share, rows.get(k)[7] / rows.get(k - 1)[1]);
            }
            lines.add(String.format(Locale.ROOT, "Rest took the energy %.3g, at most %.1e of that at the start of a "
                + "turn.", rest, share));
        }
        List<double[]> limited = rows.stream().filter(row -> !Double.isNaN(row[6])).toList();
        if (!limited.isEmpty()) {
            lines.add(String.format(Locale.ROOT, "%d of %d turns reached the bound on impacts, the first of them turn "
                + "%d: there bodies in contact kept their places.", limited.size(), rows.size() - 1,
                (int) limited.get(0)[0]));
        }
        return lines;
    }

    void writeRows(JsonGenerator out) {
        JsonObject.writeAll(out, "rows", rows, row -> {
            out.writeNumberProperty("turn", (int) row[0]);
            JsonNumbers.writeOrNull(out, "energy", row[1]);
            JsonNumbers.writeOrNull(out, "momentumX", row[2]);
            JsonNumbers.writeOrNull(out, "momentumY", row[3]);
            out.writeNumberProperty("impacts", (int) row[4]);
            JsonNumbers.writeOrNull(out, "potential", row[5]);
            JsonNumbers.writeOrNull(out, "limitTime", row[6]);
            JsonNumbers.writeOrNull(out, "rest", row[7]);
            JsonNumbers.writeOrNull(out, "restSum", row[8]);
        });
    }

    /** The rest of a row, with a comma before each number. */
    private static String cells(double... values) {
        return Arrays.stream(values).mapToObj(value -> "," + number(value)).collect(Collectors.joining("", "", "\n"));
    }

    private static String number(double value) {
        return NumberOutput.toString(value, true);
    }

    private static void write(BufferedWriter file, String row) {
        try {
            file.write(row);
        } catch (IOException problem) {
            throw new UncheckedIOException("a table cannot be written: " + problem.getMessage(), problem);
        }
    }

    @Override
    public void close() {
        try {
            for (BufferedWriter file : new BufferedWriter[] {turns, states, impacts}) {
                if (file != null) {
                    file.close();
                }
            }
        } catch (IOException problem) {
            throw new UncheckedIOException("a table cannot be written: " + problem.getMessage(), problem);
        }
    }
}
