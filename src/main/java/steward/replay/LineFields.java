package steward.replay;

import java.util.List;
import java.util.regex.Pattern;
import steward.text.NearestName;
import steward.text.TextFormat;

/**
 * Fields of the lines of replays, in their order. Every reader refuses a field that is unknown, repeated or out of
 * place: behind the hash of its line, no hash would cover it.
 */
enum LineFields {
    /** The first line. */
    HEADER(List.of("type", "format", LineFields.LAW, "angles", "game",
        LineFields.JAR, "seed", "players", "timeFactor", "signer",
        LineFields.IMPORTED, LineFields.SERVER, "scene", "drawing", "start", LineFields.HEADER_HASH, LineFields.TIMES)),
    /** A turn. */
    TURN(List.of("type", "turn", "commands", "faults", "outcome", "messages", "stderr", LineFields.SERVER,
        LineFields.TURN_HASH, LineFields.TIMES)),
    /** The last line, or the last but the signature. */
    RESULT(List.of("type", "turns", "ending", "standing", "players", "data", LineFields.SERVER,
        LineFields.RESULT_HASH, LineFields.TIMES)),
    /** Behind the result of a replay that is signed. */
    SIGNATURE(List.of("type", "isolation", "signature"));

    /** The version of the law of the scene's rung; absent for 1. */
    static final String LAW = "law";
    /** The digest of the jar that the game is from; absent for a game of the program. */
    static final String JAR = "jar";
    /** Time limits of a player of its own; absent for the scene's. */
    static final String TIME = "time";
    static final String FIRST_ANSWER = "firstAnswerMs";
    static final String ANSWER = "answerMs";
    /** True in imports of earlier versions, whose outcomes are those that a server showed. */
    static final String IMPORTED = "imported";
    /** Recording by the site's server, in an imported match. */
    static final String SERVER = "server";
    /** Type of the line of the result. */
    static final String RESULT_TYPE = "result";
    static final String HEADER_HASH = "headerHash";
    static final String TURN_HASH = "turnHash";
    static final String RESULT_HASH = "resultHash";
    static final String TIMES = "times";

    /** Characters of an unknown name that an error quotes. */
    private static final int SHOWN = 40;

    /** A name that can stand in a message without quotes. */
    private static final Pattern PLAIN = Pattern.compile("[A-Za-z_][A-Za-z_0-9]*");

    private final List<String> names;

    LineFields(List<String> names) {
        this.names = names;
    }

    /** Refuses a line that has other fields, or in another order. */
    void check(JsonLine line) {
        int last = -1;
        for (String name : line.names()) {
            int place = names.indexOf(name);
            if (place < 0) {
                String shown = TextFormat.beginning(name, SHOWN);
                throw new ReplayException(line.where() + ": "
                    + (PLAIN.matcher(name).matches() ? shown : '"' + shown + '"') + ": unknown field, expected one of "
                    + String.join(", ", names)
                    + NearestName.of(name, names).map(near -> "; did you mean " + near + "?").orElse(""));
            }
            if (place < last) {
                throw new ReplayException(line.where() + ": " + name + ": found behind " + names.get(last)
                    + ", expected before it");
            }
            last = place;
        }
        if (line.has(TIMES)) {
            new JsonLine(line.where() + ": " + TIMES, line.object(TIMES));          // nothing in it twice
        }
    }
}
