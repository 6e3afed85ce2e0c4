package steward.cli.replay;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import steward.cli.streams.Json;
import steward.text.TextFormat;

/** Scores of a moving picture, by turn: what the game says, or how many zones of a course were passed. */
final class PictureScores {

    /** Texts of a picture: with more changes than this, only the last scores are shown. */
    private static final int MOST = 600;

    private final List<double[]> byTurn = new ArrayList<>();
    private final int players;

    /** A score that a player had from one turn to another; NaN for none. */
    record Span(double score, int first, int last) {

        /** The score as text, with a space before it; empty for none. */
        String words() {
            return Double.isNaN(score) ? "" : " " + TextFormat.number(score, 2);
        }
    }

    PictureScores(int players) {
        this.players = players;
    }

    /** Takes the end of the next turn; one without a state keeps the scores before. */
    void add(Map<String, Object> outcome, Map<Integer, Integer> owners) {
        double[] scores = new double[players];
        Map<?, ?> state = outcome.get("state") instanceof Map<?, ?> found ? found : Map.of();
        Object said = outcome.get("scores") != null ? outcome.get("scores") : state.get("scores");
        for (int player = 0; player < players; player++) {
            boolean isSaid = said instanceof List<?> list && player < list.size();
            double before = byTurn.isEmpty() ? Double.NaN : byTurn.get(byTurn.size() - 1)[player];
            scores[player] = isSaid && ((List<?>) said).get(player) instanceof Double one ? one : before;
        }
        for (Map<?, ?> body : Json.objects(state.get("bodies"))) {
            Integer owner = body.get("player") instanceof Double player ? Integer.valueOf(player.intValue())
                : owners.get((int) Json.number(body.get("id")));
            if (said == null && owner != null && owner >= 0 && owner < players && isOnCourse(body)) {
                double passed = Json.number(body.get("passed"));
                scores[owner] = Double.isNaN(scores[owner]) ? passed : Math.max(scores[owner], passed);
            }
        }
        byTurn.add(scores);
    }

    /** True if a body counts the zones that it has passed: they are a course, one after the other. */
    static boolean isOnCourse(Map<?, ?> body) {
        return body.get("passed") instanceof Double;
    }

    /** Scores that a player had, in the order of time. */
    List<Span> spans(int player) {
        List<Span> spans = new ArrayList<>();
        for (int turn = 0; turn < byTurn.size(); turn++) {
            double score = byTurn.get(turn)[player];
            Span last = spans.isEmpty() ? null : spans.get(spans.size() - 1);
            if (last != null && Double.compare(last.score, score) == 0) {
                spans.set(spans.size() - 1, new Span(score, last.first, turn));
            } else {
                spans.add(new Span(score, turn, turn));
            }
        }
        return spans.size() > MOST / Math.max(1, players)
            ? List.of(new Span(byTurn.get(byTurn.size() - 1)[player], 0, byTurn.size() - 1)) : spans;
    }
}
