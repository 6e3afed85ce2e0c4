package steward.replay.verify;

import java.util.Arrays;
import steward.game.AngleVariants;
import steward.game.Game;
import steward.json.JsonNumbers;
import steward.physics.TurnLog;
import steward.replay.JsonLine;
import tools.jackson.core.JsonParser;
import tools.jackson.core.JsonToken;
import tools.jackson.core.ObjectReadContext;

/**
 * Times and impulses of another referee's impacts against ours: equal to the last bit, or within the range that a unit
 * in the last place of every sine and cosine of the turn reaches ({@link ImpactRange}), or outside of it.
 */
final class ImpactComparison {

    private int equal;
    private int within;
    private int outside;
    private int shown;
    private double[] times = {};
    private double[] impulses = {};

    /** Compares the impacts of a turn just played. */
    void add(byte[] recordedOutcome, Game played, AngleVariants variants) {
        TurnLog log = played.log();
        times = new double[log.kept()];
        impulses = new double[log.kept()];
        for (int k = 0; k < times.length; k++) {
            times[k] = log.impact(k).time();
            impulses[k] = log.impact(k).impulse();
        }
        double[] recordedTimes = times.clone();
        double[] recordedImpulses = impulses.clone();
        int recorded = read(recordedOutcome, recordedTimes, recordedImpulses);
        if (Arrays.equals(times, recordedTimes) && Arrays.equals(impulses, recordedImpulses)) {
            equal += Math.min(recorded, times.length);
            return;
        }
        ImpactRange range = new ImpactRange(played, variants);
        for (int k = 0; k < Math.min(recorded, times.length); k++) {
            if (times[k] == recordedTimes[k] && impulses[k] == recordedImpulses[k]) {
                equal++;
            } else if (range.holdsTime(k, recordedTimes[k]) && range.holdsImpulse(k, recordedImpulses[k])) {
                within++;
                times[k] = recordedTimes[k];
                impulses[k] = recordedImpulses[k];
            } else {
                outside++;
            }
        }
    }

    /** Counts the impacts of a turn all of whose recorded fields are equal to ours, as far as a server shows them. */
    void addShown(byte[] recordedOutcome) {
        shown += read(recordedOutcome, new double[0], new double[0]);
    }

    /** Reads as many as there are places for. @return how many impacts are recorded */
    private static int read(byte[] outcome, double[] times, double[] impulses) {
        JsonLine fields = new JsonLine("outcome", outcome);
        if (!fields.has("impacts")) {
            return 0;
        }
        byte[] impacts = fields.array("impacts");
        int count = 0;
        try (JsonParser in = JsonNumbers.FACTORY.createParser(ObjectReadContext.empty(), impacts, 0, impacts.length)) {
            in.nextToken();
            for (; in.nextToken() == JsonToken.START_OBJECT; count++) {
                while (in.nextToken() == JsonToken.PROPERTY_NAME) {
                    String name = in.currentName();
                    boolean number = in.nextToken().isNumeric() && count < times.length;
                    if (number && name.equals("time")) {
                        times[count] = in.getDoubleValue();
                    } else if (number && name.equals("impulse")) {
                        impulses[count] = in.getDoubleValue();
                    }
                    in.skipChildren();
                }
            }
        }
        return count;
    }

    /** The time of an impact of the turn last compared: ours, or the recorded one where that is within the range. */
    double time(int impact) {
        return times[impact];
    }

    /** Returns the impulse of an impact, ours or the recorded one, as {@link #time} does. */
    double impulse(int impact) {
        return impulses[impact];
    }

    ImpactCounts counts() {
        return new ImpactCounts(equal, within, outside, shown);
    }
}
