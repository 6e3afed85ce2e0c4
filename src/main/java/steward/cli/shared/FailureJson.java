package steward.cli.shared;

import steward.bot.TimeBasis;
import steward.bot.TimeSpent;
import steward.contest.Failure;
import steward.json.JsonNumbers;
import steward.json.JsonObject;
import tools.jackson.core.JsonGenerator;

/** Reason of a bot's failure as JSON, for programs. */
public final class FailureJson {

    private static final double NANOS_PER_MS = 1e6;

    private FailureJson() { }

    /** The turn, and what may help. */
    public static void write(JsonGenerator out, Failure failure) {
        out.writeNumberProperty("turn", failure.turn());
        out.writeStringProperty("error", failure.error().isEmpty() ? null : failure.error());
        JsonObject.writeTexts(out, "stderr", failure.stderr());
        JsonObject.writeTexts(out, "hints", failure.hints());
        writeTime(out, "time", failure.time());
    }

    /** The field {@code failure}, an object or null. */
    public static void writeField(JsonGenerator out, Failure failure) {
        out.writeName("failure");
        if (failure == null) {
            out.writeNull();
            return;
        }
        out.writeStartObject();
        write(out, failure);
        out.writeEndObject();
    }

    /** Where the time of a late answer went, in milliseconds; null for what the system does not show. */
    public static void writeTime(JsonGenerator out, String name, TimeSpent time) {
        out.writeName(name);
        if (time == null) {
            out.writeNull();
            return;
        }
        boolean any = time.shows() != TimeSpent.Shows.NOTHING;
        boolean waiting = any && time.shows() != TimeSpent.Shows.STEPS;
        out.writeStartObject();
        out.writeStringProperty("limitOf", (time.overCpu() ? TimeBasis.CPU : TimeBasis.WALL).word());
        JsonNumbers.write(out, "limitMs", time.limit() / NANOS_PER_MS);
        JsonNumbers.write(out, "takenMs", time.taken() / NANOS_PER_MS);
        JsonNumbers.writeOrNull(out, "unobservedMs", any ? time.unobserved() / NANOS_PER_MS : Double.NaN);
        JsonNumbers.writeOrNull(out, "computedMs", any ? time.computed() / NANOS_PER_MS : Double.NaN);
        JsonNumbers.writeOrNull(out, "waitedMs", waiting ? time.waited() / NANOS_PER_MS : Double.NaN);
        JsonNumbers.writeOrNull(out, "otherMs", any ? time.other() / NANOS_PER_MS : Double.NaN);
        JsonNumbers.writeOrNull(out, "cpuMs", any ? time.cpu() / NANOS_PER_MS : Double.NaN);
        out.writeBooleanProperty("inSteps", any && time.shows() != TimeSpent.Shows.ALL);
        out.writeBooleanProperty("starved", time.starved());
        out.writeEndObject();
    }
}
