package steward.cli.replay;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Map;
import steward.cli.shared.FailureJson;
import steward.cli.shared.Games;
import steward.cli.streams.Json;
import steward.cli.streams.Streams;
import steward.contest.RecordedFailures;
import steward.game.GameTypes;
import steward.json.JsonNumbers;
import steward.json.JsonObject;
import steward.match.MatchResult;
import steward.match.OwnLimits;
import steward.replay.RecordedTurn;
import steward.replay.ReplayHeader;
import steward.replay.ReplayReader;
import steward.replay.verify.ReplayDifference;
import steward.replay.verify.Verification;
import steward.text.TextFormat;
import tools.jackson.core.JsonGenerator;

/** Output of {@code steward replay} for programs: one JSON object with facts of the match. */
record ReplayJson(Streams streams, ReplayReader replay) {

    /** The match and its result. */
    void summary() {
        RecordedFailures failures = new RecordedFailures(Games.types(), replay);
        int turns = 0;
        long impacts = 0;
        for (RecordedTurn turn = replay.next(); turn != null; turn = replay.next()) {
            turns = turn.number();
            failures.add(turn);
            Map<String, Object> outcome = Json.object(turn.outcome());
            impacts += outcome.containsKey("impactsInAll") ? (long) Json.number(outcome.get("impactsInAll"))
                : Json.objects(outcome.get("impacts")).size();
        }
        int played = turns;
        long counted = impacts;
        Json.print(streams, out -> summary(out, played, counted, failures));
    }

    private void summary(JsonGenerator out, int turns, long impacts, RecordedFailures failures) {
        ReplayHeader header = replay.header();
        MatchResult result = RecordedResult.of(replay, replay.header().names());
        out.writeStringProperty("scene", Json.word(Json.object(header.scene()).get("name"), 0));
        out.writeStringProperty("game", header.game());
        out.writeStringProperty("seed", Long.toString(header.seed()));
        out.writeNumberProperty("turns", turns);
        out.writeNumberProperty("impacts", impacts);
        out.writeStringProperty("ending", result == null ? null : result.ending());
        JsonNumbers.writeOrNull(out, "winner", result == null || result.winner() < 0 ? Double.NaN : result.winner());
        JsonObject.writeAll(out, "players", header.names().size(), player -> {
            out.writeStringProperty("name", header.names().get(player));
            out.writeStringProperty("bot", header.bots().get(player));
            out.writeStringProperty(OwnLimits.FIELD,
                OwnLimits.writtenOrNull(OwnLimits.of(header.limits().get(player))));
            if (result != null) {
                out.writeNumberProperty("rank", result.players().get(player).rank());
                out.writeNumberProperty("score", result.players().get(player).score());
                out.writeStringProperty("fault", result.players().get(player).fault());
                out.writeStringProperty("out", result.players().get(player).out());
            }
        });
        JsonObject.writeAll(out, "failures", failures.failures(), failure -> {
            out.writeNumberProperty("player", failure.player());
            out.writeStringProperty("fault", failure.reason());
            FailureJson.write(out, failure);
        });
        out.writeStringProperty("warning", replay.warning());
    }

    /** One turn: what was recorded of it, angles in radians. */
    void turn(int number, GameTypes types) {
        TurnDetail detail = new TurnDetail(null, replay, types);
        RecordedTurn turn = detail.find(number);
        String[] sent = detail.sent(turn);
        Json.print(streams, out -> turn(out, turn, sent));
    }

    private static void turn(JsonGenerator out, RecordedTurn turn, String[] sent) {
        out.writeNumberProperty("turn", turn.number());
        texts(out, "sent", sent);
        raw(out, "commands", turn.commands());
        texts(out, "faults", turn.faults());
        texts(out, "messages", turn.messages());
        texts(out, "stderr", turn.stderr());
        raw(out, "outcome", turn.outcome());
    }

    private static void raw(JsonGenerator out, String name, byte[] json) {
        out.writeName(name);
        out.writeRawValue(TextFormat.escaped(new String(json, StandardCharsets.UTF_8), ""));
    }

    private static void texts(JsonGenerator out, String name, String[] texts) {
        JsonObject.writeTexts(out, name, Arrays.asList(texts));
    }

    /** The impacts of a range of turns, both ends included, as they were recorded. */
    void impacts(int from, int to) {
        Map<Integer, Object> turns = new LinkedHashMap<>();
        int last = 0;
        for (RecordedTurn turn = replay.next(); turn != null && turn.number() <= to; turn = replay.next()) {
            last = turn.number();
            Object recorded = Json.object(turn.outcome()).get("impacts");
            if (last >= from && !Json.objects(recorded).isEmpty()) {
                turns.put(last, recorded);
            }
        }
        if (last < from) {
            throw TurnDetail.noSuchTurn(replay, from, last);
        }
        Json.print(streams, out -> {
            JsonObject.writeAll(out, "turns", turns.entrySet(), turn -> {
                out.writeNumberProperty("turn", turn.getKey());
                out.writeName("impacts");
                Json.write(out, turn.getValue());
            });
            out.writeStringProperty("warning", replay.warning());
        });
    }

    /**
     * Prints whether playing it again gave the same, and whether it is signed as the report demands.
     *
     * @return the exit status
     */
    int verification(Verification verification, VerifyReport report) {
        ReplayDifference difference = verification.difference();
        String wrong = report.wrong(replay, verification);
        Json.print(streams, out -> {
            out.writeBooleanProperty("verified", wrong == null && verification.verified());
            out.writeStringProperty("reason", wrong);
            out.writeNumberProperty("turns", verification.turns());
            out.writeName("difference");
            if (difference == null) {
                out.writeNull();
            } else {
                out.writeStartObject();
                out.writeNumberProperty("turn", difference.turn());
                out.writeStringProperty("field", difference.field());
                out.writeStringProperty("recorded", difference.recorded());
                out.writeStringProperty("found", difference.found());
                out.writeEndObject();
            }
            if (!report.views().notCompared().isEmpty()) {
                out.writeNumberProperty("values", report.views().values());
                out.writeNumberProperty("near", report.views().nearInAll());
                JsonObject.writeTexts(out, "notCompared", report.views().notCompared());
            }
            out.writeStringProperty("olderLaw", verification.olderLaw());
            out.writeStringProperty("isolation", verification.signature().isolation());
            out.writeStringProperty("warning", verification.warning());
        });
        return report.status(wrong, verification);
    }
}
