package steward.cli.play;

import java.util.List;
import steward.cli.shared.Streams;
import steward.contest.Contest;
import steward.contest.Series;
import steward.contest.Tally;
import steward.game.JsonNumbers;
import steward.match.MatchResult;
import tools.jackson.core.JsonGenerator;

/** The result of a series for programs: one JSON object on one line, the same however many threads played it. */
final class SeriesJson {

    private SeriesJson() {
    }

    static void print(Streams streams, Series series, List<Series.Played> games) {
        MatchJson.printObject(streams, out -> {
            out.writeStringProperty("scene", series.contest().sceneName());
            out.writeStringProperty("seed", Long.toString(series.first()));
            out.writeNumberProperty("seeds", series.seeds());
            out.writeBooleanProperty("swap", series.swap());
            out.writeNumberProperty("games", games.size());
            JsonNumbers.writeOrNull(out, "meanTurns", SeriesText.meanTurns(games));
            out.writeArrayPropertyStart("bots");
            for (int k = 0; k < series.contest().entrants().size(); k++) {
                out.writeStartObject();
                writeBot(out, series.contest().entrants().get(k), Tally.of(series, games, k));
                out.writeEndObject();
            }
            out.writeEndArray();
            out.writeArrayPropertyStart("list");
            for (Series.Played game : games) {
                out.writeStartObject();
                writeGame(out, series, game);
                out.writeEndObject();
            }
            out.writeEndArray();
        });
    }

    private static void writeBot(JsonGenerator out, Contest.Entrant entrant, Tally tally) {
        out.writeStringProperty("name", entrant.name());
        out.writeStringProperty("bot", entrant.bot());
        out.writeNumberProperty("wins", tally.wins());
        out.writeNumberProperty("draws", tally.draws());
        out.writeNumberProperty("losses", tally.losses());
        out.writeNumberProperty("faults", tally.faults());
        JsonNumbers.writeOrNull(out, "points", tally.points());
        out.writeArrayPropertyStart("interval95");
        if (tally.games() > 0) {
            JsonNumbers.write(out, tally.low());
            JsonNumbers.write(out, tally.high());
        }
        out.writeEndArray();
    }

    private static void writeGame(JsonGenerator out, Series series, Series.Played game) {
        out.writeNumberProperty("game", game.number());
        out.writeStringProperty("seed", Long.toString(game.seed()));
        out.writeArrayPropertyStart("order");
        for (int player = 0; player < series.contest().entrants().size(); player++) {
            out.writeNumber(series.contest().entrantOf(player, game.rotation()));
        }
        out.writeEndArray();
        MatchResult result = game.result();
        if (result == null) {
            out.writeStringProperty("failure", game.failure());
        } else {
            out.writeNumberProperty("turns", result.turns());
            out.writeStringProperty("ending", result.ending());
            out.writeArrayPropertyStart("ranks");
            for (MatchResult.PlayerResult player : result.players()) {
                out.writeNumber(player.rank());
            }
            out.writeEndArray();
            out.writeArrayPropertyStart("faults");
            for (MatchResult.PlayerResult player : result.players()) {
                if (player.fault() == null) {
                    out.writeNull();
                } else {
                    out.writeString(player.fault());
                }
            }
            out.writeEndArray();
        }
        out.writeStringProperty("replay", series.folder() == null ? null : series.file(game.number()).toString());
    }
}
