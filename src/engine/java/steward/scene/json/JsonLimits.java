package steward.scene.json;

/**
 * Limits on size and depth of a JSON file that a person writes: more than a person needs, yet read or refused in a
 * moment. They apply while reading: the first value too many is the last one looked at.
 */
public final class JsonLimits {

    /** Most bytes of a file: 250,000 short values. */
    public static final int BYTES = 4 << 20;
    /** Most elements of an array: maps, walls, bumpers. */
    static final int ELEMENTS = 1000;
    /** Most lines of a CSV file that a scene has taken in. */
    public static final int ROWS = 200_001;
    /** Most bytes of such a file. */
    public static final int ROW_BYTES = 64 << 20;
    /** Path of the lines of such a file: they are counted by themselves. */
    static final String ROWS_PATH = ".csv.lines";
    /** Most fields of an object; the largest known to a reader has some ten. */
    static final int FIELDS = 100;
    /** Most values of a file: those of a thousand maps of 64 checkpoints, and some more. */
    static final int VALUES = 250_000;
    /** Objects and arrays within each other; a scene needs six. */
    static final int DEPTH = 16;
    /** Characters (Unicode code points) of a text. */
    public static final int TEXT = 1000;
    /** Characters (Unicode code points) of a field's name. */
    static final int NAME = 100;

    private final String source;
    private int values;

    JsonLimits(String source) {
        this.source = source;
    }

    /** Counts a value that begins. */
    void value(SourcePosition place, String path) {
        values += path.contains(ROWS_PATH + "[") ? 0 : 1;
        check(values <= VALUES, place, path, "more than " + VALUES + " values", VALUES + " in a file");
    }

    void depth(int depth, SourcePosition place, String path) {
        check(depth <= DEPTH, place, path, "nesting deeper than " + DEPTH, String.valueOf(DEPTH));
    }

    /** @param count elements, the one at this place included */
    void elements(int count, SourcePosition place, String path) {
        int most = path.endsWith(ROWS_PATH) ? ROWS : ELEMENTS;
        check(count <= most, place, path, "more than " + most + " elements", String.valueOf(most));
    }

    /** @param count fields, the one at this place included */
    void fields(int count, SourcePosition place, String path) {
        check(count <= FIELDS, place, path, "more than " + FIELDS + " fields", String.valueOf(FIELDS));
    }

    void text(String text, SourcePosition place, String path) {
        int length = text.codePointCount(0, text.length());
        check(length <= TEXT, place, path, "a text of " + length + " characters", String.valueOf(TEXT));
    }

    /** @param path of the object that has the field */
    void name(String name, SourcePosition place, String path) {
        int length = name.codePointCount(0, name.length());
        check(length <= NAME, place, path, "a field's name of " + length + " characters", String.valueOf(NAME));
    }

    private void check(boolean within, SourcePosition place, String path, String found, String most) {
        if (!within) {
            throw SceneException.at(source, place, path, "found " + found + ", expected at most " + most);
        }
    }
}
