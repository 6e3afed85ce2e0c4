package steward.scene.price;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.StringJoiner;
import steward.numerics.Median;
import steward.scene.Part;
import steward.scene.Scene;
import steward.scene.SceneKey;

/**
 * Stored prices of parts, as shares of the turn: measured once on the shipped scenes and shipped with the program. A
 * scene that is none of these gets the median of those of its game.
 *
 * @param rows  of the scenes that the shares are taken from, at least one
 * @param exact whether these are of the very scene
 */
public record StoredPartPrices(List<Row> rows, boolean exact) {

    /** Where the program has them. */
    public static final String RESOURCE = "/steward/part-prices.csv";
    /** The columns of the file. */
    public static final List<String> COLUMNS = List.of("scene", "game", "key", "rung", "part", "in", "share", "error",
        "date", "machine");

    /** Between the cells of a line. */
    public static final String SEPARATOR = ";";

    /**
     * A line of the file.
     *
     * @param scene   name of the shipped scene
     * @param game    its game
     * @param key     its {@link SceneKey}
     * @param rung    on which it was measured
     * @param part    name of the part, or {@link PartPrice#EMPTY}
     * @param in      whether the scene has it
     * @param share   what it adds, as a share of the scene's whole turn; below 0 if it saves
     * @param error   by how much the share may be wrong
     * @param date    of the measurement, as year-month-day
     * @param machine of the measurement
     */
    public record Row(String scene, String game, String key, String rung, String part, boolean in, double share,
                      double error, String date, String machine) {

        /** The row as a line of the file, without its end. */
        public String line() {
            StringJoiner line = new StringJoiner(SEPARATOR);
            for (String cell : List.of(scene, game, key, rung, part, Boolean.toString(in), number(share),
                number(error), date, machine)) {
                line.add(cell.replace(SEPARATOR, ","));
            }
            return line.toString();
        }

        private static String number(double value) {
            return String.format(Locale.ROOT, "%.4f", value);
        }

        static Row read(String line) {
            String[] cells = line.split(SEPARATOR, -1);
            if (cells.length != COLUMNS.size()) {
                throw new IllegalStateException(RESOURCE + ": found the line \"" + line + "\", expected "
                    + COLUMNS.size() + " cells");
            }
            return new Row(cells[0], cells[1], cells[2], cells[3], cells[4], Boolean.parseBoolean(cells[5]),
                Double.parseDouble(cells[6]), Double.parseDouble(cells[7]), cells[8], cells[9]);
        }
    }

    /** All rows that come with the program. */
    public static List<Row> all() {
        try (InputStream in = StoredPartPrices.class.getResourceAsStream(RESOURCE)) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8).lines().skip(1).map(Row::read).toList();
        } catch (IOException problem) {
            throw new UncheckedIOException(problem);
        }
    }

    /** The stored shares for a scene: its own, else those of its game, else those of all games. */
    public static StoredPartPrices of(Scene scene) {
        return of(scene, all());
    }

    static StoredPartPrices of(Scene scene, List<Row> all) {
        String key = SceneKey.of(scene);
        List<Row> own = all.stream().filter(row -> row.key.equals(key)).toList();
        if (!own.isEmpty()) {
            String first = own.get(0).scene;
            return new StoredPartPrices(own.stream().filter(row -> row.scene.equals(first)).toList(), true);
        }
        List<Row> ofGame = all.stream().filter(row -> row.game.equals(scene.gameId())).toList();
        return new StoredPartPrices(ofGame.isEmpty() ? all : ofGame, false);
    }

    /** The price of a part as a share of a turn, or {@code null} if none was measured. */
    public PartPrice price(Part part) {
        Row[] found = rows.stream().filter(row -> row.part.equals(part.name())).toArray(Row[]::new);
        return found.length == 0 ? null : new PartPrice(part.name(), part.in(),
            Median.of(Arrays.stream(found).mapToDouble(Row::share).toArray()),
            Arrays.stream(found).mapToDouble(Row::error).max().getAsDouble());
    }

    /** The names of the scenes. */
    public List<String> scenes() {
        return rows.stream().map(Row::scene).distinct().toList();
    }
}
