package steward.codingame.recording;

import java.io.OutputStream;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import steward.game.Game;
import steward.game.GameSetup;
import steward.game.GameType;
import steward.game.GameTypes;
import steward.game.ServerView;
import steward.game.podrace.RulesEdition;
import steward.replay.ServerRecording;
import steward.text.ViewLines;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ObjectNode;

/** Importer of CodinGame's own JSON into a replay, for any game that tells how its views are read. */
final class ServerGameImport implements RecordingImport, ImportedMatch.Frames {

    private static final String WITH_RULES = "pod-race";

    private final List<ServerFrames.Turn> turns;
    private final ServerView view;
    private final long seed;
    private final GameSetup setup;
    private final ServerRecording.End end;
    private final RecordingFacts facts;
    /** Frames of the start and of each turn. */
    private final List<List<ServerRecording.Frame>> shown = new ArrayList<>();

    private ServerGameImport(ServerFrames frames, GameType type, String source, GameTypes types, RulesEdition rules) {
        frames.requireStart();
        if (rules != null && !type.id().equals(WITH_RULES)) {
            throw otherGame(source);
        }
        view = type.serverView().orElseThrow();
        ServerView.Start start = view.open(frames.first(), frames.input());
        seed = start.seed();
        setup = types.open(rules == null ? start.scene() : byRules(start.scene(), rules), source + " (scene)");
        int players = setup.scene().players();
        if (frames.players() > players) {
            throw new IllegalArgumentException(source + ": found answers of " + frames.players()
                + " players, expected " + players + " of " + setup.scene().gameId());
        }
        double[] scores = frames.scores(players);
        int[] ranks = frames.ranks(players);
        turns = frames.turns(players, ranks.length > 0);
        int played = turns.size();
        while (played > 0 && turns.get(played - 1).isSilent()) {
            played--;
        }
        end = new ServerRecording.End(played, List.of(), words(IntStream.of(ranks).mapToObj(Integer::toString)),
            words(DoubleStream.of(scores).mapToObj(Double::toString)), null, null);
        facts = frames.facts(players);
        shown.add(List.of(frames.shown(0, false)));
        turns.forEach(turn -> shown.add(turn.frames()));
    }

    /** Refusal of a game that has no rules to name. */
    static IllegalArgumentException otherGame(String source) {
        return new IllegalArgumentException(source + ": found another game, expected a pod race where rules are named");
    }

    /** Numbers in one text; {@code null} if there are none. */
    static String words(Stream<String> numbers) {
        String words = numbers.collect(Collectors.joining(" "));
        return words.isEmpty() ? null : words;
    }

    private static String byRules(String scene, RulesEdition rules) {
        ObjectNode root = (ObjectNode) JsonMapper.shared().readTree(scene);
        ((ObjectNode) root.get("race")).put("rules", rules.word());
        return root.toString();
    }

    /**
     * Reads a recording.
     *
     * @param rules edition of the rules by which a pod race was played; {@code null} for those of today
     * @throws IllegalArgumentException if it is of a game that is not known, or wrong
     */
    static ServerGameImport of(JsonNode gameResult, String source, GameTypes types, RulesEdition rules) {
        ServerFrames frames = new ServerFrames(gameResult, source);
        ViewLines first = frames.first();
        List<String> known = new ArrayList<>();
        for (GameType type : types.types()) {
            ServerView view = type.serverView().orElse(null);
            if (view != null && view.isOf(first)) {
                return new ServerGameImport(frames, type, source, types, rules);
            }
            known.addAll(view == null ? List.of() : List.of(view.title()));
        }
        throw first.wrong(1, "the name of a game that is known: " + String.join(", ", known));
    }

    @Override
    public Imported write(OutputStream out) throws InterruptedException {
        List<RecordedPlayer> players = new ArrayList<>();
        for (int player = 0; player < setup.scene().players(); player++) {
            List<List<String>> said = new ArrayList<>();
            for (ServerFrames.Turn turn : turns) {
                said.add(turn.said().get(player));
            }
            players.add(new RecordedPlayer(facts.names().get(player), said, view));
        }
        return new ImportedMatch(setup, seed, this, end, facts, players).write(out);
    }

    @Override
    public boolean has(int turn) {
        return turn < shown.size();
    }

    @Override
    public List<ServerRecording.Frame> of(int turn, Game game) {
        return shown.get(turn);
    }

    @Override
    public List<ServerRecording.Frame> behind(int turn) {
        return shown.subList(turn + 1, shown.size()).stream().flatMap(List::stream).toList();
    }
}
