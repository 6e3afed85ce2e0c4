package steward.codingame.recording;

import java.io.OutputStream;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.regex.Pattern;
import steward.game.GameSetup;
import steward.game.GameType;
import steward.game.GameTypes;
import steward.game.ServerView;
import steward.text.ViewLines;
import tools.jackson.core.JsonGenerator;
import tools.jackson.databind.JsonNode;

/** CodinGame's own JSON of any game that says how its views are read. */
final class ServerGameImport implements RecordingImport {

    private static final String POD_RACE = "CodersStrikeBack";
    private static final Pattern TITLE = Pattern.compile("[A-Za-z][A-Za-z0-9 _'-]{2,60}");

    private final List<ServerFrames.Turn> turns;
    private final ServerView.Shown shown;
    private final GameSetup setup;
    private final int[] ranks;
    private final double[] scores;
    private final GameFacts facts;
    private final ShownFrame first;

    private ServerGameImport(ServerFrames frames, ServerView view, String source, GameTypes types) {
        frames.requireStart();
        int players = frames.players();
        shown = view.open(frames.first(), frames.input(), players);
        setup = types.open(shown.scene(), source + " (scene)");
        if (setup.scene().players() != players) {
            throw new IllegalArgumentException(source + ": found answers of " + players + " players, expected "
                + setup.scene().players() + " of " + setup.scene().gameId());
        }
        turns = frames.turns(players);
        turns.forEach(turn -> shown.add(turn.view()));
        ranks = frames.ranks(players);
        scores = frames.scores(players);
        facts = frames.facts(players);
        first = frames.firstShown();
    }

    /**
     * @return {@code null} if this is a recording of the pod race, or none at all
     * @throws IllegalArgumentException if it is of a game that is not known, or wrong
     */
    static ServerGameImport of(JsonNode gameResult, String source, GameTypes types) {
        JsonNode start = gameResult.get("frames").get(0);
        if (!start.isObject() || !start.path("view").isString()) {
            return null;
        }
        ServerFrames frames = new ServerFrames(gameResult, source);
        ViewLines first = frames.first();
        String title = first.line(1).strip();
        List<String> known = new ArrayList<>(List.of(POD_RACE));
        for (GameType type : types.types()) {
            ServerView view = type.serverView().orElse(null);
            if (view != null && view.isOf(first)) {
                return new ServerGameImport(frames, view, source, types);
            }
            known.addAll(view == null ? List.of() : List.of(view.title()));
        }
        if ((title.startsWith("{") || TITLE.matcher(title).matches()) && !title.equals(POD_RACE)) {
            throw first.wrong(1, "the name of a game that is known: " + String.join(", ", known));
        }
        return null;
    }

    @Override
    public Imported write(OutputStream out) throws InterruptedException {
        List<RecordedPlayer> players = new ArrayList<>();
        for (int player = 0; player < setup.scene().players(); player++) {
            int number = player;
            List<List<String>> said = new ArrayList<>();
            turns.forEach(turn -> said.add(turn.said().get(number)));
            players.add(new RecordedPlayer(facts.names().get(player), said,
                (frame, answerLines) -> Collections.nCopies(answerLines, shown.idle())));
        }
        return new ImportedMatch(setup, shown.seed(), new Seen(), facts, players).write(out);
    }

    /** Observations that the server has shown. */
    private final class Seen implements ServerObservations {

        @Override
        public int turns() {
            return turns.size();
        }

        @Override
        public boolean isSilent(int turn) {
            return turns.get(turn - 1).isSilent();
        }

        @Override
        public boolean isOver() {
            return ranks.length > 0;
        }

        @Override
        public boolean hasStart() {
            return true;
        }

        @Override
        public void writeStart(JsonGenerator out) {
            shown.writeStart(out);
            ShownFrame.write(out, List.of(first));
        }

        @Override
        public void writeOutcome(JsonGenerator out, int turn) {
            shown.writeOutcome(out, turn);
            ShownFrame.write(out, turns.get(turn - 1).frames());
        }

        @Override
        public int rank(int player) {
            return ranks.length == 0 ? -1 : ranks[player];
        }

        @Override
        public double score(int player) {
            return shown.score(player, scores);
        }
    }
}
