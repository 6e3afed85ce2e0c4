package steward.cli.replay;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Map;
import steward.cli.shared.FailureReason;
import steward.cli.shared.Games;
import steward.cli.streams.Json;
import steward.cli.streams.Streams;
import steward.contest.RecordedFailures;
import steward.game.GameTypes;
import steward.match.MatchResult;
import steward.match.OwnLimits;
import steward.replay.RecordedTurn;
import steward.replay.ReplayHeader;
import steward.replay.ReplayReader;
import steward.replay.verify.ReplayDifference;
import steward.replay.verify.Verification;
import steward.report.Fields;
import steward.text.TextFormat;

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
        ReplayHeader header = replay.header();
        MatchResult result = RecordedResult.of(replay, replay.header().names());
        Json.print(streams, Fields.of("scene", Json.word(Json.object(header.scene()).get("name"), 0),
            "game", header.game(), "seed", Long.toString(header.seed()), "turns", turns, "impacts", impacts,
            "ending", result == null ? null : result.ending(),
            "winner", result == null || result.winner() < 0 ? null : result.winner(),
            "players", Fields.each(header.names().size(), player -> {
                Fields fields = Fields.of("name", header.names().get(player), "bot", header.bots().get(player),
                    OwnLimits.FIELD, OwnLimits.writtenOrNull(OwnLimits.of(header.limits().get(player))));
                if (result != null) {
                    MatchResult.PlayerResult of = result.players().get(player);
                    fields.with("rank", of.rank(), "score", Fields.decimal(of.score()), "fault", of.fault(),
                        "out", of.out());
                }
                return fields;
            }), "failures", Fields.each(failures.failures(), failure -> Fields.of("player", failure.player(),
                "fault", failure.reason()).and(FailureReason.fields(failure))), "warning", replay.warning()));
    }

    /** One turn: what was recorded of it, angles in radians. */
    void turn(int number, GameTypes types) {
        TurnDetail detail = new TurnDetail(null, replay, types);
        RecordedTurn turn = detail.find(number);
        String[] sent = detail.sent(turn);
        Json.print(streams, Fields.of("turn", turn.number(), "sent", Arrays.asList(sent),
            "commands", raw(turn.commands()), "faults", Arrays.asList(turn.faults()),
            "messages", Arrays.asList(turn.messages()), "stderr", Arrays.asList(turn.stderr()),
            "outcome", raw(turn.outcome())));
    }

    private static Fields.Raw raw(byte[] json) {
        return new Fields.Raw(TextFormat.escaped(new String(json, StandardCharsets.UTF_8), ""));
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
        Json.print(streams, Fields.of("turns", Fields.each(turns.entrySet(),
            turn -> Fields.of("turn", turn.getKey(), "impacts", turn.getValue())), "warning", replay.warning()));
    }

    /**
     * Prints whether playing it again gave the same, and whether it is signed as the report demands.
     *
     * @return the exit status
     */
    int verification(Verification verification, VerifyReport report) {
        ReplayDifference difference = verification.difference();
        String wrong = report.wrong(replay, verification);
        Fields fields = Fields.of("verified", wrong == null && verification.verified(), "reason", wrong,
            "turns", verification.turns(), "difference", difference == null ? null : Fields.of(
                "turn", difference.turn(), "field", difference.field(), "recorded", difference.recorded(),
                "found", difference.found()));
        if (!report.views().notCompared().isEmpty()) {
            fields.with("values", report.views().values(), "near", report.views().nearInAll(),
                "notCompared", report.views().notCompared());
        }
        Json.print(streams, fields.with("olderLaw", verification.olderLaw(),
            "isolation", verification.signature().isolation(), "warning", verification.warning()));
        return report.status(wrong, verification);
    }
}
