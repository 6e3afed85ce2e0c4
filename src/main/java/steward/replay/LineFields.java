package steward.replay;

import java.util.List;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import steward.text.NearestName;
import steward.text.TextFormat;

/**
 * The fields that lines of replays have, in their order, by format. Every reader refuses a field that is unknown,
 * repeated or out of place: behind the hash of its line, no hash would cover it.
 */
enum LineFields {
    /** The first line. */
    HEADER(List.of("type", "format", LineFields.LAW, "angles", "game", "seed", "players", "timeFactor", "signer",
        "imported", "scene", "drawing", "start", LineFields.HEADER_HASH, LineFields.TIMES),
        Set.of(LineFields.LAW, "angles", "signer", LineFields.TIMES)),
    /** A turn. */
    TURN(List.of("type", "turn", "commands", "faults", "outcome", "messages", "stderr", LineFields.TURN_HASH,
        LineFields.TIMES), Set.of()),
    /** A turn of formats 1 and 2. */
    EARLIER_TURN(List.of("type", "turn", "commands", "faults", LineFields.INPUT_HASH, "outcome", "messages", "stderr",
        LineFields.TIMES), Set.of()),
    /** The last line, or the last but the signature. */
    RESULT(List.of("type", "turns", "ending", "standing", "players", "data", LineFields.RESULT_HASH, LineFields.TIMES),
        Set.of()),
    /** Behind the result of a replay that is signed. */
    SIGNATURE(List.of("type", "isolation", "signature"), Set.of());

    /** The version of the law of the scene's rung; absent for 1. */
    static final String LAW = "law";
    static final String HEADER_HASH = "headerHash";
    static final String TURN_HASH = "turnHash";
    /** In formats 1 and 2, the hash of what the players did in a turn. */
    static final String INPUT_HASH = "inputHash";
    static final String RESULT_HASH = "resultHash";
    static final String TIMES = "times";
    /** The first format that names its angles, and has the hash of all lines last. */
    static final int ANGLES_SINCE = 3;

    /** How much of an unknown name an error quotes, in characters. */
    private static final int SHOWN = 40;

    /** A name that can stand in a message without quotes. */
    private static final Pattern PLAIN = Pattern.compile("[A-Za-z_][A-Za-z_0-9]*");

    private final List<String> names;
    private final Set<String> later;

    /** @param later the fields that formats 1 and 2 do not have */
    LineFields(List<String> names, Set<String> later) {
        this.names = names;
        this.later = later;
    }

    /** Refuses a line that has other fields, or in another order. */
    void check(JsonLine line, int format) {
        List<String> known = format >= ANGLES_SINCE ? names
            : names.stream().filter(name -> !later.contains(name)).toList();
        int last = -1;
        for (String name : line.names()) {
            int place = known.indexOf(name);
            if (place < 0) {
                String shown = TextFormat.beginning(name, SHOWN);
                throw new ReplayException(line.where() + ": "
                    + (PLAIN.matcher(name).matches() ? shown : '"' + shown + '"') + ": unknown field, expected one of "
                    + known.stream().collect(Collectors.joining(", "))
                    + NearestName.of(name, known).map(near -> "; did you mean " + near + "?").orElse(""));
            }
            if (place < last) {
                throw new ReplayException(line.where() + ": " + name + ": found behind " + known.get(last)
                    + ", expected before it");
            }
            last = place;
        }
        if (line.has(TIMES)) {
            new JsonLine(line.where() + ": " + TIMES, line.object(TIMES));          // nothing in it twice
        }
    }
}
