package steward.league.store;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.function.Predicate;
import java.util.regex.Pattern;
import steward.files.InputException;
import steward.league.GameName;
import steward.league.LeagueReader;
import steward.league.Season;
import steward.league.StoredGame;
import steward.league.StoredGame.StoredSeat;
import steward.league.store.GameStore.Version;
import steward.match.OwnLimits;
import steward.numerics.StateHash;
import steward.text.TextFormat;

/**
 * One game as a line of text fields, for other programs and other leagues. It has the conditions and the result, and
 * each seat with the identity of its bot. Replays are not part of it.
 */
public final class GameLine {

    private static final String TRANSCRIPT = "transcript";
    private static final String VALUES = "values";
    /** Rank of the last of 16 players, as the database has it. */
    private static final int WORST_RANK = 15;

    /** The fields of the game itself. */
    public static final List<String> GAME = List.of("name", "sceneKey", "limits", "rules", "decision", "seed",
        "attempt", "counts", "turns", "problem", "played", "machine", GameLine.TRANSCRIPT);
    /** The fields of a seat. */
    public static final List<String> SEAT = List.of("bot", "number", "identity", "command", "random", "rank", "score",
        "fault", "answers", "meanNanos", "worstNanos", "firstNanos", GameLine.VALUES, OwnLimits.FIELD);

    private static final Predicate<String> IDENTITY = Pattern.compile("[0-9a-f]{1,64}").asMatchPredicate();
    /** Characters of a command or a machine at most. */
    private static final int LONGEST_LINE = 10_000;
    private static final int LONGEST_SHOWN = 60;

    private GameLine() { }

    /** The fields of a game, in the order of {@link #GAME}; absent ones are empty. */
    public static Map<String, String> game(StoredGame game, Season season) {
        return fields(GAME, List.of(HexFormat.of().formatHex(game.name()), season.sceneKey(), season.limits(),
            season.rules(), game.decision() < 0 ? "" : Integer.toString(game.decision()), Long.toString(game.seed()),
            Integer.toString(game.attempt()), Boolean.toString(game.counts()), Integer.toString(game.turns()),
            game.problem() == null ? "" : game.problem(), Long.toString(game.played()), game.machine(),
            game.transcript() == 0 ? "" : StateHash.toHex(game.transcript())));
    }

    private static Map<String, String> fields(List<String> names, List<String> values) {
        Map<String, String> fields = new LinkedHashMap<>();
        for (int k = 0; k < names.size(); k++) {
            fields.put(names.get(k), values.get(k));
        }
        return fields;
    }

    /** The fields of a seat, in the order of {@link #SEAT}. */
    public static Map<String, String> seat(StoredSeat seat, Version version) {
        return fields(SEAT, List.of(version.bot(), Integer.toString(version.number()), version.identity(),
            version.command(), Boolean.toString(version.random()), Integer.toString(seat.rank()),
            Double.toString(seat.score()), seat.fault() == null ? "" : seat.fault(), Integer.toString(seat.answers()),
            Long.toString(seat.meanNanos()), Long.toString(seat.worstNanos()), Long.toString(seat.firstNanos()),
            seat.valuesText(), version.timeLimit() == null ? "" : version.timeLimit()));
    }

    /**
     * Reads games back; gives bots that this store does not know a version. Decisions are those of another league: if
     * this one comes to such a game, it has it.
     */
    public static final class Reader {

        private final GameStore store;
        private final Season season;
        private final Map<String, Version> versions = new LinkedHashMap<>();

        /** @param season that the games have to be of */
        public Reader(GameStore store, Season season) {
            this.store = store;
            this.season = season;
        }

        /**
         * Reads a game.
         *
         * @param place names the line in errors
         * @throws InputException if it is of another season, or not what it says it is
         */
        public StoredGame read(String place, Map<String, String> game, List<Map<String, String>> seats) {
            return read(place, game, seats, true);
        }

        /** Checks a game as {@link #read} does, but gives no bot a version. */
        public void check(String place, Map<String, String> game, List<Map<String, String>> seats) {
            read(place, game, seats, false);
        }

        private StoredGame read(String place, Map<String, String> game, List<Map<String, String>> seats,
                                boolean known) {
            Season found = Season.of(season.sceneName(), text(place, game, "sceneKey"), text(place, game, "limits"),
                text(place, game, "rules"), season.players(), season.lowerScoreIsBetter());
            if (!found.key().equals(season.key())) {
                throw new InputException(place + ": found a game of another season, expected one of this league's: "
                    + season.difference(found));
            }
            if (seats.size() != season.players()) {
                throw new InputException(place + ": found " + seats.size() + " seats, expected " + season.players());
            }
            long seed = number(place, game, "seed", Long.MIN_VALUE, Long.MAX_VALUE);
            int attempt = (int) number(place, game, "attempt", 1, Integer.MAX_VALUE);
            byte[] name = GameName.of(season, seed,
                seats.stream().map(seat -> matching(place, seat, "identity", IDENTITY, "up to 64 hexadecimal digits"))
                    .toList(), attempt);
            if (!HexFormat.of().formatHex(name).equals(text(place, game, "name"))) {
                throw new InputException(place + ": name: found '" + game.get("name")
                    + "', expected that of its seed, attempt and identities, " + HexFormat.of().formatHex(name));
            }
            List<StoredSeat> stored = new ArrayList<>();
            seats.forEach(seat -> stored.add(seat(place, seat,
                known ? version(place, seat).id() : checked(place, seat))));
            String problem = inOneLine(game.getOrDefault("problem", ""));
            return new StoredGame(0, name, -1, seed, attempt,
                flag(place, game, "counts") && problem.isEmpty(),
                (int) number(place, game, "turns", 0, Integer.MAX_VALUE), problem.isEmpty() ? null : problem,
                number(place, game, "played", 0, Long.MAX_VALUE), line(place, game, "machine"), null,
                transcript(place, game), stored);
        }

        private static int checked(String place, Map<String, String> seat) {
            matching(place, seat, "bot", LeagueReader::isName, LeagueReader.NAME_FORM);
            line(place, seat, "command");
            timeLimit(place, seat);
            flag(place, seat, "random");
            return 0;
        }

        /** A text that is printed as it is: in one line, and without characters that steer a terminal. */
        private static String line(String place, Map<String, String> fields, String name) {
            return matching(place, fields, name, text -> text.length() <= LONGEST_LINE
                && text.chars().noneMatch(c -> TextFormat.isUnsafe((char) c)), "a line of at most " + LONGEST_LINE
                + " characters without control characters");
        }

        private static String matching(String place, Map<String, String> fields, String name, Predicate<String> form,
                                       String expected) {
            String text = text(place, fields, name);
            if (!form.test(text)) {
                throw new InputException(place + ": " + name + ": found '" + inOneLine(TextFormat.shorten(text,
                    LONGEST_SHOWN)) + "', expected " + expected);
            }
            return text;
        }

        private static String inOneLine(String text) {
            return TextFormat.plain(text).replace('\n', '?').replace('\t', '?');
        }

        private static StoredSeat seat(String place, Map<String, String> seat, int version) {
            String fault = inOneLine(seat.getOrDefault("fault", ""));
            return new StoredSeat(version, (int) number(place, seat, "rank", 0, WORST_RANK),
                score(place, seat), fault.isEmpty() ? null : fault,
                (int) number(place, seat, "answers", 0, Integer.MAX_VALUE),
                number(place, seat, "meanNanos", 0, Long.MAX_VALUE),
                number(place, seat, "worstNanos", 0, Long.MAX_VALUE),
                number(place, seat, "firstNanos", 0, Long.MAX_VALUE), values(place, seat));
        }

        private static long transcript(String place, Map<String, String> game) {
            String found = game.getOrDefault(TRANSCRIPT, "");
            if (!found.isEmpty() && !found.matches("[0-9a-f]{16}")) {
                throw new InputException(place + ": " + TRANSCRIPT + ": found '" + found
                    + "', expected 16 hexadecimal digits");
            }
            return found.isEmpty() ? 0 : Long.parseUnsignedLong(found, 16);
        }

        private static SortedMap<String, Double> values(String place, Map<String, String> seat) {
            return InputException.of(place + ": " + VALUES + ": ",
                () -> StoredSeat.values(seat.getOrDefault(VALUES, "")));
        }

        private static double score(String place, Map<String, String> seat) {
            try {
                double score = Double.parseDouble(text(place, seat, "score"));
                if (Double.isFinite(score)) {
                    return score;
                }
            } catch (NumberFormatException problem) {
                // Told below.
            }
            throw new InputException(place + ": score: found '" + seat.get("score") + "', expected a finite number");
        }

        private static String timeLimit(String place, Map<String, String> seat) {
            String text = seat.getOrDefault(OwnLimits.FIELD, "");
            try {
                return text.isEmpty() ? null : OwnLimits.parse(text).written();
            } catch (IllegalArgumentException problem) {
                throw new InputException(place + ": " + OwnLimits.FIELD + ": " + inOneLine(problem.getMessage()));
            }
        }

        private Version version(String place, Map<String, String> seat) {
            String identity = text(place, seat, "identity");
            return versions.computeIfAbsent(identity, key -> store.version(identity).orElseGet(() ->
                store.add(text(place, seat, "bot"), text(place, seat, "command"), timeLimit(place, seat),
                    flag(place, seat, "random"), identity, System.currentTimeMillis())));
        }

        private static String text(String place, Map<String, String> fields, String name) {
            String text = fields.get(name);
            if (text == null || text.isEmpty()) {
                throw new InputException(place + ": " + name + ": found nothing, expected a value");
            }
            return text;
        }

        private static boolean flag(String place, Map<String, String> fields, String name) {
            String text = text(place, fields, name);
            if (!Arrays.asList("true", "false").contains(text)) {
                throw new InputException(place + ": " + name + ": found '" + text + "', expected true or false");
            }
            return text.equals("true");
        }

        private static long number(String place, Map<String, String> fields, String name, long low, long high) {
            String text = text(place, fields, name);
            try {
                long number = Long.parseLong(text);
                if (number >= low && number <= high) {
                    return number;
                }
            } catch (NumberFormatException problem) {
                // Told below.
            }
            throw new InputException(place + ": " + name + ": found '" + text + "', expected a whole number"
                + (low == Long.MIN_VALUE ? "" : " from " + low));
        }
    }
}
