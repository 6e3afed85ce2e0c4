package steward.cli.play;

import java.nio.file.Path;
import java.util.List;
import steward.cli.shared.FailureJson;
import steward.cli.streams.Streams;
import steward.contest.AnswerTimes;
import steward.contest.Contest;
import steward.contest.Failure;
import steward.contest.Series;
import steward.contest.SeriesPlay;
import steward.contest.Standings;
import steward.contest.Tally;
import steward.contest.loss.Losses;
import steward.league.sequential.ScoreRange;
import steward.json.JsonNumbers;
import steward.json.JsonObject;
import steward.match.MatchResult;
import steward.match.OwnLimits;
import tools.jackson.core.JsonGenerator;

/**
 * Result of a series for programs: one JSON object on one line. It is the same for any number of threads, except for
 * its last field, {@code times}, and for measurements of late and held bots.
 */
final class SeriesJson {

    private static final double NANOS_PER_MS = 1e6;

    static void print(Streams streams, Series series, SeriesPlay play, List<String> choosers,
                      Losses why) {
        MatchJson.printObject(streams, out -> write(out, series, play, choosers, why));
    }

    /** The fields of the object. */
    static void write(JsonGenerator out, Series series, SeriesPlay play, List<String> choosers, Losses why) {
        Standings standings = play.standings();
        out.writeStringProperty("scene", series.contest().sceneName());
        out.writeStringProperty("seed", Long.toString(series.first()));
        out.writeNumberProperty("seeds", series.seeds());
        JsonObject.writeTexts(out, "choosers", choosers);
        out.writeBooleanProperty("swap", series.swap());
        out.writeBooleanProperty("alone", series.contest().isAlone());
        out.writeNumberProperty("planned", series.games());
        out.writeNumberProperty("games", standings.games().size());
        out.writeNumberProperty("results", standings.results());
        out.writeNumberProperty("allFailed", standings.allFailed().size());
        JsonNumbers.writeAll(out, "repeats", standings.repeats().size(),
            k -> standings.repeats().get(k).number());
        JsonNumbers.writeOrNull(out, "superiority", SeriesText.superiority(series, standings));
        out.writeBooleanProperty("interrupted", play.isBrokenOff());
        out.writeStringProperty("stopped", play.stopped());
        out.writeStringProperty("keep", series.keep().word());
        out.writeStringProperty("time", series.contest().time().basis().word());
        out.writeStringProperty("hiccups", series.hiccups().word());
        out.writeNumberProperty("playedAgain", standings.playedAgain().size());
        out.writeStringProperty("sandbox", series.contest().sandbox());
        out.writeStringProperty("hold", series.contest().hold());
        JsonNumbers.writeOrNull(out, "meanTurns", standings.meanTurns());
        JsonObject.writeAll(out, "bots", series.contest().entrants().size(),
            k -> writeBot(out, series, series.contest().entrants().get(k), standings.tally(k)));
        FailureReport.json(out, standings.failures());
        if (why != null) {
            out.writeObjectPropertyStart("why");
            why.json(out);
            out.writeEndObject();
        }
        JsonObject.writeAll(out, "list", standings.games(), game -> writeGame(out, series, game));
        JsonObject.writeAll(out, "times", series.contest().entrants().size(),
            k -> writeTimes(out, standings.times(k)));
    }

    private static void writeBot(JsonGenerator out, Series series, Contest.Entrant entrant, Tally tally) {
        out.writeStringProperty("name", entrant.name());
        out.writeStringProperty("bot", entrant.bot());
        out.writeStringProperty(OwnLimits.FIELD, OwnLimits.writtenOrNull(entrant.limits()));
        out.writeNumberProperty("wins", tally.wins());
        out.writeNumberProperty("draws", tally.draws());
        out.writeNumberProperty("losses", tally.losses());
        out.writeNumberProperty("allFailed", tally.allFailed());
        out.writeNumberProperty("faults", tally.faults());
        JsonNumbers.writeOrNull(out, "points", tally.points());
        out.writeArrayPropertyStart("interval95");
        if (!Double.isNaN(tally.points())) {
            ScoreRange range = ScoreRange.of(SeriesText.scores(series, tally));
            JsonNumbers.write(out, range.low());
            JsonNumbers.write(out, range.high());
        }
        out.writeEndArray();
        JsonNumbers.writeOrNull(out, "meanScore", tally.score());
    }

    private static void writeGame(JsonGenerator out, Series series, Series.Played game) {
        out.writeNumberProperty("game", game.number());
        out.writeStringProperty("seed", Long.toString(game.seed()));
        JsonNumbers.writeAll(out, "order", series.contest().players(),
            player -> series.contest().entrantOf(player, game.rotation()));
        if (game.result() == null) {
            out.writeStringProperty("failure", game.failure());
        } else {
            writeResult(out, game.result(), game.failures());
        }
        writePath(out, game.replay());
        writeStarved(out, game.starved());
    }

    /** The game as it was played before, with what it was played again for in turn; null for none. */
    private static void writeStarved(JsonGenerator out, Series.Played before) {
        out.writeName("starved");
        if (before == null) {
            out.writeNull();
            return;
        }
        out.writeStartObject();
        writeResult(out, before.result(), before.failures());
        writePath(out, before.replay());
        if (before.starved() != null) {
            writeStarved(out, before.starved());
        }
        out.writeEndObject();
    }

    private static void writeResult(JsonGenerator out, MatchResult result, List<Failure> failures) {
        out.writeNumberProperty("turns", result.turns());
        out.writeStringProperty("ending", result.ending());
        JsonObject.writeEach(out, "ranks", result.players(), player -> out.writeNumber(player.rank()));
        JsonObject.writeEach(out, "scores", result.players(), player -> JsonNumbers.write(out, player.score()));
        JsonObject.writeEach(out, "faults", result.players(), player -> out.writeString(player.fault()));
        int[] turns = new int[result.players().size()];
        failures.forEach(failure -> turns[failure.player()] = failure.turn());
        JsonObject.writeEach(out, "faultTurns", turns.length, player -> MatchJson.writeTurn(out, turns[player]));
        JsonObject.writeEach(out, "heldFrom", result.players(), player -> MatchJson.writeTurn(out, player.heldFrom()));
        JsonObject.writeEach(out, "lateAnswers", failures, failure -> {
            if (failure.time() != null) {
                out.writeStartObject();
                out.writeNumberProperty("player", failure.player());
                FailureJson.writeTime(out, "time", failure.time());
                if (failure.burner() != null) {
                    out.writeNumberProperty("burner", failure.burner().player());
                    JsonNumbers.write(out, "burnerProcessors", failure.burner().processors());
                }
                out.writeEndObject();
            }
        });
    }

    /** In the order of the bots; milliseconds. */
    private static void writeTimes(JsonGenerator out, AnswerTimes times) {
        boolean any = times.count() > 0;
        out.writeNumberProperty("answers", times.count());
        JsonNumbers.writeOrNull(out, "mean", times.meanNanos() / NANOS_PER_MS);
        JsonNumbers.writeOrNull(out, "p99", any ? times.quantileNanos(SeriesText.PERCENTILE) / NANOS_PER_MS
            : Double.NaN);
        JsonNumbers.writeOrNull(out, "worst", any ? times.worstNanos() / NANOS_PER_MS : Double.NaN);
        out.writeName("worstGame");
        if (any) {
            out.writeNumber(times.worstGame());
            out.writeNumberProperty("worstTurn", times.worstTurn());
        } else {
            out.writeNull();
            out.writeNullProperty("worstTurn");
        }
        JsonNumbers.writeOrNull(out, "meanFirst", times.meanFirstNanos() / NANOS_PER_MS);
        JsonNumbers.writeOrNull(out, "worstFirst", Double.isNaN(times.meanFirstNanos()) ? Double.NaN
            : times.worstFirstNanos() / NANOS_PER_MS);
    }

    private static void writePath(JsonGenerator out, Path replay) {
        out.writeStringProperty("replay", replay == null ? null : replay.toString());
    }
}
