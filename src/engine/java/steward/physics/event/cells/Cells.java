package steward.physics.event.cells;

import java.util.Arrays;
import steward.physics.Bodies;
import steward.physics.event.flight.PairSelection;

/*
 * Two bodies whose diameters are at most the side of a cell touch only while they are in the same cell or in cells next
 * to each other. Where cells are wider than that by 2 h, each body may even be up to h outside the cell where it is
 * listed: centres in two cells that are not next to each other are then still a diameter apart. So a cell crossing
 * happens only when a body is h outside its cell, and many bodies have an impact before that.
 *
 * The grid has no border: column and row numbers are taken modulo its size, so that a body may fly anywhere without
 * more memory; a body far away shares a cell with others and is only tested with them in addition. Two columns and rows
 * on each side are empty at first, for bodies that fly out during a turn.
 *
 * Bodies of larger diameter, or very far away, are in no cell: see Crowd.
 */

/**
 * Grid of square cells, each with a list of its bodies. Size and number are chosen anew for each turn, from the bodies
 * at its start.
 */
final class Cells {

    /**
     * The wanted mean number of bodies in a cell, where their sizes allow it. From 0.7 to 0.9 an impact costs about the
     * same: change it and see {@code steward bench --only crowds}.
     */
    private static final double PER_CELL = 0.7;
    /**
     * Columns and rows from this distance from the origin on are too far: there, roundings would come close to the
     * slack.
     */
    static final int FAR = 1 << 20;
    /** By how much a cell is larger than a diameter, relatively: far more than the rounding errors of positions. */
    static final double SLACK = 1 + 0x1p-20;
    /** The share of the room h outside a cell that is used; the rest is slack. */
    private static final double USED_SHARE = 1 - 0x1p-10;
    /** Columns and rows that are empty at first on each side. */
    private static final int MARGIN = 2;
    /** Bodies are sorted by squares of so many cells a side; change it and see {@code bench --only crowds}. */
    private static final int TILE = 8;
    private static final int SAMPLE = 64;
    /** The maximum number of bodies that are left out of the grid for their size. */
    private static final int MOST_LARGE = 16;

    private final double[] sample = new double[SAMPLE];
    private final double[] largest = new double[MOST_LARGE + 1];
    private final double slack;
    private int columns;
    private int rows;
    private int[] heads = new int[0];
    /** Two entries per body: the next one in its cell, and how often its flight has changed, for its neighbours. */
    private int[] links = new int[0];
    private double originX;
    private double originY;
    private double side;
    private double perSide;
    private double beyond;
    private double largestInside;

    /** @param slack by how much a cell is larger than a diameter, at least {@link #SLACK} */
    Cells(double slack) {
        this.slack = slack;
    }

    /**
     * Chooses the size and number of cells for these bodies, at least one; {@link #sort} then empties them.
     *
     * @param selection see {@link Crowd#radius}
     */
    void begin(Bodies bodies, PairSelection selection) {
        int size = bodies.size();
        findLargest(bodies, selection);
        int sampled = sample(bodies.x, size);
        double width = Math.max(spread(sample, sampled), 2 * largest[0]);
        originX = lowest(bodies.x, size, sample[sampled / 10] - width);
        sample(bodies.y, size);
        double height = Math.max(spread(sample, sampled), 2 * largest[0]);
        originY = lowest(bodies.y, size, sample[sampled / 10] - height);
        chooseSide(size, width * height / size);
        originX -= MARGIN * side;
        originY -= MARGIN * side;
        double wide = Math.min(4.0 * size, Math.ceil(3 * width / side));
        double high = Math.min(4.0 * size, Math.ceil(3 * height / side));
        columns = cellCount(bodies.x, size, originX, wide);
        rows = cellCount(bodies.y, size, originY, high);
        while ((long) columns * rows > 4L * size + 64) {
            if (columns > rows) {
                columns = columns / 2 + 1;
            } else {
                rows = rows / 2 + 1;
            }
        }
        if (heads.length < columns * rows) {
            heads = new int[Math.min(columns * rows * 9 / 8, 4 * size + 64)];
        }
        if (links.length < 2 * size) {
            links = new int[2 * bodies.capacity()];
        }
    }

    /** Fills {@code sample} with some of the values, sorted. @return how many */
    private int sample(double[] values, int size) {
        int sampled = Math.min(SAMPLE, size);
        for (int k = 0; k < sampled; k++) {
            sample[k] = values[(int) ((long) k * size / sampled)];
        }
        sort(sample, sampled);
        return sampled;
    }

    private void findLargest(Bodies bodies, PairSelection selection) {
        Arrays.fill(largest, 0);
        for (int k = 0; k < bodies.size(); k++) {
            double radius = Crowd.radius(selection, bodies, k);
            int place = MOST_LARGE;
            if (radius > largest[place]) {
                while (place > 0 && radius > largest[place - 1]) {
                    largest[place] = largest[place - 1];
                    place--;
                }
                largest[place] = radius;
            }
        }
    }

    /**
     * Chooses how many of the largest bodies to leave out so that a search, of nine cells and of the bodies left out,
     * costs least; and the side of a cell that follows.
     */
    private void chooseSide(int size, double areaOfOne) {
        double wanted = Math.sqrt(PER_CELL * areaOfOne);
        double rounding = 0x1p-48 * (Math.abs(originX) + Math.abs(originY));
        double cheapest = Double.POSITIVE_INFINITY;
        for (int out = 0; out <= MOST_LARGE && largest[out] > 0; out++) {
            double needed = Math.max(wanted, 2 * largest[out] * slack + rounding);
            double cost = out + 9 * needed * needed / areaOfOne;
            if (out == 0 || cost < cheapest) {
                cheapest = cost;
                side = needed;
                largestInside = largest[out];
                beyond = USED_SHARE / 2 * (needed - (2 * largest[out] * slack + rounding));
            }
        }
        perSide = 1 / side;
    }

    private static double lowest(double[] values, int size, double bound) {
        double lowest = values[0];
        for (int k = 1; k < size; k++) {
            lowest = Math.min(lowest, values[k]);
        }
        return Math.max(lowest, bound);
    }

    private int cellCount(double[] values, int size, double origin, double bound) {
        double most = origin;
        for (int k = 0; k < size; k++) {
            most = Math.max(most, values[k]);
        }
        return Math.max(3, (int) Math.min(Math.ceil((most - origin) * perSide) + MARGIN, bound + 2 * MARGIN));
    }

    /** The range of the values without the lowest and the highest tenth, enlarged in proportion. */
    private static double spread(double[] sorted, int count) {
        int tenth = count / 10;
        return (sorted[count - 1 - tenth] - sorted[tenth]) * count / (count - 2.0 * tenth);
    }

    private static void sort(double[] values, int count) {
        for (int k = 1; k < count; k++) {
            double value = values[k];
            int place = k;
            while (place > 0 && values[place - 1] > value) {
                values[place] = values[place - 1];
                place--;
            }
            values[place] = value;
        }
    }

    /**
     * Orders indices by tiles, in a tile by cells, ascending within a cell: a counting sort. So neighbours stay on few
     * pages of memory, even after a turn in which bodies have flown through some cells.
     */
    void sort(Bodies bodies, int[] index) {
        int cells = columns * rows;
        Arrays.fill(heads, 0, cells, 0);
        for (int k = 0; k < bodies.size(); k++) {
            heads[cellAt(column(bodies.x[k]), row(bodies.y[k]))]++;
        }
        int before = 0;
        for (int fromRow = 0; fromRow < rows; fromRow += TILE) {
            for (int fromColumn = 0; fromColumn < columns; fromColumn += TILE) {
                before = countTile(fromColumn, fromRow, before);
            }
        }
        for (int k = 0; k < bodies.size(); k++) {
            index[heads[cellAt(column(bodies.x[k]), row(bodies.y[k]))]++] = k;
        }
        Arrays.fill(heads, 0, cells, -1);
    }

    /** Replaces the numbers of bodies in the cells of a tile by those before each. @return the number after the last */
    private int countTile(int fromColumn, int fromRow, int from) {
        int before = from;
        int endColumn = Math.min(columns, fromColumn + TILE);
        for (int row = fromRow; row < Math.min(rows, fromRow + TILE); row++) {
            for (int cell = row * columns + fromColumn; cell < row * columns + endColumn; cell++) {
                before += heads[cell];
                heads[cell] = before - heads[cell];
            }
        }
        return before;
    }

    /** True if a body of this radius is kept in a cell. */
    boolean holds(double radius) {
        return radius <= largestInside;
    }

    /** The column of a position; {@link #FAR} if it is too far away. */
    int column(double x) {
        return cellNumber((x - originX) * perSide);
    }

    int row(double y) {
        return cellNumber((y - originY) * perSide);
    }

    private static int cellNumber(double value) {
        double floor = Math.floor(value);
        return Math.abs(floor) < FAR ? (int) floor : FAR;
    }

    /** The width and height of a cell. */
    double side() {
        return side;
    }

    double middleX(int column) {
        return originX + (column + 0.5) * side;
    }

    double middleY(int row) {
        return originY + (row + 0.5) * side;
    }

    /** The greatest distance of a body from the middle of its cell, along each axis. */
    double reach() {
        return side / 2 + beyond;
    }

    int cellAt(int column, int row) {
        return wrap(row, rows) * columns + wrap(column, columns);
    }

    private static int wrap(int number, int count) {
        return number >= 0 && number < count ? number : Math.floorMod(number, count);
    }

    void add(int body, int cell) {
        links[2 * body] = heads[cell];
        heads[cell] = body;
    }

    void remove(int body, int cell) {
        int at = heads[cell];
        if (at == body) {
            heads[cell] = links[2 * body];
            return;
        }
        while (links[2 * at] != body) {
            at = links[2 * at];
        }
        links[2 * at] = links[2 * body];
    }

    /**
     * Collects the bodies in the nine cells around a cell, and returns how many: first the heads of all lists, then the
     * bodies that follow them, in one loop without a branch for empty cells.
     *
     * @param into room for one more than the number of bodies
     */
    int gatherAround(int column, int row, int[] into) {
        return appendFollowing(into, appendHeads(column, row, into, 0));
    }

    /**
     * Appends the first body of each of the nine cells around a cell, and returns how many there are then.
     *
     * @param into room for nine more
     */
    int appendHeads(int column, int row, int[] into, int before) {
        int left = wrap(column - 1, columns);
        int middle = wrap(column, columns);
        int right = wrap(column + 1, columns);
        int count = before;
        for (int r = row - 1; r <= row + 1; r++) {
            int line = wrap(r, rows) * columns;
            count = append(heads[line + left], into, count);
            count = append(heads[line + middle], into, count);
            count = append(heads[line + right], into, count);
        }
        return count;
    }

    /**
     * Appends the first body of each of three cells: the one given, and those one step before and after it.
     *
     * @param into room for three more
     */
    int appendSideHeads(int column, int row, int stepColumn, int stepRow, int[] into, int before) {
        int count = append(heads[cellAt(column - stepColumn, row - stepRow)], into, before);
        count = append(heads[cellAt(column, row)], into, count);
        return append(heads[cellAt(column + stepColumn, row + stepRow)], into, count);
    }

    /** The first body of a cell, or -1. */
    int first(int column, int row) {
        return heads[cellAt(column, row)];
    }

    /** The number of times that the flight of a body has changed since it was loaded. */
    int changes(int body) {
        return links[2 * body + 1];
    }

    void countChange(int body) {
        links[2 * body + 1]++;
    }

    void clearChanges(int body) {
        links[2 * body + 1] = 0;
    }

    /** The body that follows another one in its cell, or -1. */
    int following(int body) {
        return links[2 * body];
    }

    /** Collects the bodies of three cells: the one given, and those one step before and after it. */
    int gatherSide(int column, int row, int stepColumn, int stepRow, int[] into) {
        return appendFollowing(into, appendSideHeads(column, row, stepColumn, stepRow, into, 0));
    }

    private int appendFollowing(int[] into, int heads) {
        int count = heads;
        for (int k = 0; k < count; k++) {
            count = append(links[2 * into[k]], into, count);
        }
        return count;
    }

    /** Appends without a branch: -1, the end of a list, is overwritten by the next entry. */
    private static int append(int body, int[] into, int count) {
        into[count] = body;
        return count + 1 + (body >> 31);
    }
}
