package steward.game.searchrace.protocol;

import steward.game.searchrace.SearchRace;
import steward.game.searchrace.SearchRaceSettings;
import steward.json.JsonAnswer;
import tools.jackson.core.JsonParser;
import tools.jackson.core.JsonToken;

/**
 * Reader of one answer, {@code {"x":1,"y":2.5,"thrust":100}} or {@code {"turn":-18,"thrust":200}}, also from a replay.
 * There {@code "debug":true} says that the answer's message asked for times.
 */
final class SearchRaceAnswer extends JsonAnswer {

    private double x;
    private double y;
    private double turn;
    private double thrust;
    private boolean debug;

    private SearchRaceAnswer(String... fields) {
        super(fields);
    }

    static SearchRaceAnswer ofBot() {
        return new SearchRaceAnswer("x", "y", "turn", "thrust");
    }

    static SearchRaceAnswer ofReplay() {
        return new SearchRaceAnswer("x", "y", "turn", "thrust", "debug");
    }

    @Override
    protected void begin() {
        x = Double.NaN;
        y = Double.NaN;
        turn = Double.NaN;
        thrust = Double.NaN;
        debug = false;
    }

    @Override
    protected String field(String name, JsonParser in) {
        double value = name.equals("debug") ? 0 : number(in);
        switch (name) {
            case "x" -> {
                return Double.isNaN(x) ? finite(name, x = value, in) : twice(name);
            }
            case "y" -> {
                return Double.isNaN(y) ? finite(name, y = value, in) : twice(name);
            }
            case "turn" -> {
                int most = SearchRaceSettings.MAXIMUM_TURN;
                return Double.isNaN(turn) ? whole(name, turn = value, -most, most, in) : twice(name);
            }
            case "thrust" -> {
                return Double.isNaN(thrust) ? whole(name, thrust = value, 0, SearchRaceSettings.MAXIMUM_THRUST, in)
                    : twice(name);
            }
            default -> {
                debug = in.currentToken() == JsonToken.VALUE_TRUE;
                return debug ? null : name + ": found " + found(in) + ", expected true (or leave it out)";
            }
        }
    }

    private static String twice(String name) {
        return name + ": found twice, expected once";
    }

    private static String finite(String name, double value, JsonParser in) {
        return Double.isNaN(value) ? name + ": found " + found(in) + ", expected a finite number" : null;
    }

    private static String whole(String name, double value, int least, int most, JsonParser in) {
        return isWhole(value, least, most) ? null
            : name + ": found " + found(in) + ", expected a whole number " + least + ".." + most;
    }

    @Override
    protected String complete() {
        if (Double.isNaN(turn) && (Double.isNaN(x) || Double.isNaN(y))) {
            return Double.isNaN(x) && Double.isNaN(y) ? "found neither x and y nor turn, expected one of them"
                : (Double.isNaN(x) ? "x" : "y") + ": found nothing, expected a number";
        }
        if (!Double.isNaN(turn) && !(Double.isNaN(x) && Double.isNaN(y))) {
            return "turn: found beside x and y, expected either turn, or x and y";
        }
        return Double.isNaN(thrust) ? "thrust: found nothing, expected a whole number 0.."
            + SearchRaceSettings.MAXIMUM_THRUST : null;
    }

    /** Makes what was read the command for the next turn. */
    void command(SearchRace race) {
        if (Double.isNaN(turn)) {
            race.toward(x + 0.0, y + 0.0, (int) thrust);
        } else {
            race.turn((int) turn, (int) thrust);
        }
        if (debug) {
            race.askForTimes();
        }
    }
}
