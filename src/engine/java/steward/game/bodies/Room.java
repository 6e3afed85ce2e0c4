package steward.game.bodies;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import steward.physics.Wall;

/**
 * Grid of the discs that are placed already, which tells whether there is room for one more. Each disc is in all cells
 * that its box covers; the largest covers some {@value #MOST_CELLS} in a direction.
 */
final class Room {

    /** Overlap that rounding may cause, as a share of a radius. */
    private static final double TOLERANCE = 1e-9;
    private static final int MOST_CELLS = 50;

    private final List<Wall> walls;
    private final double cell;
    private final List<double[]> discs = new ArrayList<>();
    private final Map<Long, List<Integer>> cells = new TreeMap<>();

    Room(List<Wall> walls, double usualRadius, double largestRadius) {
        this.walls = walls;
        cell = Math.max(2 * usualRadius, largestRadius / MOST_CELLS);
    }

    void add(double x, double y, double radius) {
        int number = discs.size();
        discs.add(new double[] {x, y, radius});
        for (long column = cell(x - radius); column <= cell(x + radius); column++) {
            for (long row = cell(y - radius); row <= cell(y + radius); row++) {
                cells.computeIfAbsent(key(column, row), any -> new ArrayList<>()).add(number);
            }
        }
    }

    /** The lowest disc that overlaps with this one, or -1. */
    int overlapped(double x, double y, double radius) {
        int lowest = Integer.MAX_VALUE;
        for (long column = cell(x - radius); column <= cell(x + radius); column++) {
            for (long row = cell(y - radius); row <= cell(y + radius); row++) {
                for (int number : cells.getOrDefault(key(column, row), List.of())) {
                    double[] disc = discs.get(number);
                    double dx = x - disc[0];
                    double dy = y - disc[1];
                    double reach = (radius + disc[2]) * (1 - TOLERANCE);
                    if (number < lowest && dx * dx + dy * dy < reach * reach) {
                        lowest = number;
                    }
                }
            }
        }
        return lowest == Integer.MAX_VALUE ? -1 : lowest;
    }

    /** The lowest wall that a disc is in or behind, or -1. */
    int wall(double x, double y, double radius) {
        for (int w = 0; w < walls.size(); w++) {
            if (walls.get(w).gap(x, y, radius) < -TOLERANCE * radius) {
                return w;
            }
        }
        return -1;
    }

    boolean has(double x, double y, double radius) {
        return wall(x, y, radius) < 0 && overlapped(x, y, radius) < 0;
    }

    private long cell(double coordinate) {
        return (long) Math.floor(coordinate / cell);
    }

    /** Cells that share a number cost time and nothing else. */
    private static long key(long column, long row) {
        return column * 0x9E3779B97F4A7C15L ^ row;
    }
}
