package steward.game;

import java.util.ArrayList;
import java.util.List;
import steward.physics.Impact;
import steward.physics.TurnLog;
import tools.jackson.databind.JsonNode;

/**
 * A match of a published referee, played again by a game's rules and the site's lines: everything is compared. A game
 * says how a recorded state is set, and how its states and impacts are read.
 */
public abstract class VectorReplay<G extends Game> {

    /** The recorded match. */
    protected final VectorMatch match;
    /** The scene of the match. */
    protected final GameSetup setup;
    /** Differences found so far, and the number of values compared. */
    protected final Comparison comparison;

    protected VectorReplay(VectorMatch match, GameSetup setup) {
        this.match = match;
        this.setup = setup;
        comparison = new Comparison(match.name());
    }

    /** Returns a game at its start, as the rules give it. */
    protected abstract G create();

    /**
     * Returns a game that goes on from a recorded state.
     *
     * @param fresh at its start; may be used by several states, and is not changed
     */
    protected abstract G in(G fresh, JsonNode state);

    /** Compares what the header tells of the start. */
    protected void compareStart(G game) { }

    /**
     * Compares the impacts of the turn that was played: bounces are impacts of the log, what a game does itself is
     * facts of it, each in their order.
     */
    protected void compareImpacts(String when, JsonNode turn, G game) {
        TurnLog log = game.log();
        int impact = 0;
        int fact = 0;
        for (JsonNode of : turn.get("impacts")) {
            String what = when + " impact " + (impact + fact) + " ";
            comparison.impact();
            boolean isFact = isFact(of, log, fact);
            if (isFact ? fact >= log.facts() : impact >= log.impacts()) {
                comparison.same(what, of.toString(), "none");
                return;
            } else if (isFact) {
                fact += compareFact(what, of, log, fact);
            } else {
                compareImpact(what, of, log.impact(impact++));
            }
        }
        comparison.same(when + " impacts", log.impacts(), impact);
        comparison.same(when + " facts", log.facts(), fact);
    }

    /** True if a recorded impact has to be a fact of the log. @param fact the next one, if there is any */
    protected boolean isFact(JsonNode of, TurnLog log, int fact) {
        return false;
    }

    /** Compares a recorded impact with the facts of the log from one on. @return how many of them it is */
    protected int compareFact(String what, JsonNode of, TurnLog log, int fact) {
        throw new UnsupportedOperationException();
    }

    /** Compares a recorded impact with one of the log. */
    protected void compareImpact(String what, JsonNode of, Impact impact) {
        throw new UnsupportedOperationException();
    }

    /** Compares the state after a turn. */
    protected abstract void compareState(String when, JsonNode state, G game);

    /** Returns the score as the referee reports it. */
    protected abstract Object score(G game, int player);

    /** Returns the lines that each player was sent in a turn, or {@code null} where they were not recorded. */
    protected JsonNode inputs(JsonNode turn) {
        return turn.get("inputs");
    }

    /** Returns what each player answered: lines, a word for a timeout, or null where it was not asked. */
    protected JsonNode commands(JsonNode turn) {
        return turn.get("commands");
    }

    /** Plays the match from its start, or from each state that was set by hand, to the end. */
    public final Comparison compareWhole() {
        G fresh = create();
        G game = match.isInjected() ? in(fresh, match.start()) : create();
        compareStart(game);
        compareState("turn 0", match.start(), game);
        for (JsonNode turn : match.turns()) {
            String when = "turn " + turn.get("turn").asInt();
            if (turn.has("before")) {
                game = in(fresh, turn.get("before"));
            } else if (game.isOver()) {
                comparison.same(when, "a turn", "over: " + game.ending());
                return comparison;
            }
            compareTurn(when, turn, game);
        }
        if (match.isWhole()) {
            compareEnd(game);
        }
        return comparison;
    }

    /** Plays each turn from the recorded state before it. */
    public final Comparison compareTurnByTurn() {
        G fresh = create();
        JsonNode before = match.start();
        for (JsonNode turn : match.turns()) {
            JsonNode state = turn.has("before") ? turn.get("before") : before;
            compareTurn("turn " + turn.get("turn").asInt() + " alone", turn, in(fresh, state));
            before = turn.get("state");
        }
        return comparison;
    }

    /** Plays a turn and compares it. */
    protected void compareTurn(String when, JsonNode turn, G game) {
        answer(when, commands(turn), inputs(turn), turn.get("turn").asInt() == 1, game);
        game.play();
        compareImpacts(when, turn, game);
        compareState(when, turn.get("state"), game);
    }

    /** One player after another: who is asked later may see that an earlier one is out. */
    protected final void answer(String when, JsonNode commands, JsonNode inputs, boolean first, G game) {
        TextCodec lines = setup.textCodec(game).orElseThrow();
        for (int player = 0; player < game.players(); player++) {
            if (inputs != null && !inputs.get(player).isNull()) {
                String text = (first ? CodecText.setup(lines, player) : "") + CodecText.turn(lines, player);
                comparison.same(when + " input of player " + player, texts(inputs.get(player)), text.lines().toList());
                compareAsked(when + " player " + player + " ", player, lines, game);
            }
            JsonNode answer = commands.get(player);
            if (answer.isNull()) {
                comparison.same(when + " player " + player + " is asked", false,
                    game.isIn(player) && !game.isDecided());
            } else if (!answer.isArray()) {
                game.eliminate(player, "no answer in time");
            } else {
                String wrong = CodecText.read(lines, player, String.join("\n", texts(answer)));
                if (wrong != null) {
                    game.eliminate(player, wrong);
                }
            }
        }
    }

    /** Compares what else is known of a player who is asked. */
    protected void compareAsked(String what, int player, TextCodec lines, G game) { }

    /** Compares how the match ended. */
    protected void compareEnd(G game) {
        compareEnd(game, game.turn());
    }

    /** @param turns that were played */
    protected final void compareEnd(G game, int turns) {
        comparison.same("end, turns", match.end().get("turnsPlayed").asInt(), turns);
        comparison.same("end, is over", true, game.isOver());
        for (int player = 0; player < game.players(); player++) {
            comparison.same("end, score of " + player, match.end().get("scores").get(player).asString(),
                player + " " + score(game, player));
        }
    }

    /** Returns the whole numbers of a list. */
    protected static List<Integer> numbers(JsonNode list) {
        List<Integer> numbers = new ArrayList<>();
        list.forEach(each -> numbers.add(each.asInt()));
        return numbers;
    }

    /** Returns the texts of a list. */
    protected static List<String> texts(JsonNode list) {
        List<String> texts = new ArrayList<>();
        list.forEach(each -> texts.add(each.asString()));
        return texts;
    }
}
