package steward.cli.play;

import java.util.List;
import java.util.function.UnaryOperator;
import steward.cli.streams.Colour;
import steward.cli.streams.Streams;
import steward.game.Game;
import steward.game.GameJson;
import steward.game.TurnEvent;
import steward.match.MatchListener;
import steward.match.Turn;
import steward.text.TextFormat;

/** News of a running match on a terminal: a line per headline, change of the lead and fault. */
final class TurnProgress implements MatchListener {

    private static final int NOBODY = -1;

    private final Streams streams;
    private final Colour colour;
    private final List<String> names;
    private Game game;
    private int leader = NOBODY;

    /** @param names of the players, in order */
    TurnProgress(Streams streams, List<String> names) {
        this.streams = streams;
        colour = streams.outColour();
        this.names = names;
    }

    @Override
    public void start(Game startedGame, GameJson codec) {
        game = startedGame;
    }

    @Override
    public void played(Turn turn) {
        for (int player = 0; player < turn.players(); player++) {
            if (turn.fault(player) != null) {
                say(turn, names.get(player) + " is out: " + turn.fault(player), colour::bad);
            }
        }
        for (TurnEvent event : game.events()) {
            if (event.headline()) {
                say(turn, event.text(), UnaryOperator.identity());
            }
        }
        int now = leader();
        if (now != NOBODY && now != leader) {
            say(turn, names.get(now) + " leads", colour::strong);
            leader = now;
        }
    }

    private int leader() {
        int[] ranks = game.ranks();
        int best = NOBODY;
        for (int player = 0; player < ranks.length; player++) {
            if (ranks[player] == 0 && best != NOBODY) {
                return NOBODY;
            }
            best = ranks[player] == 0 ? player : best;
        }
        return best;
    }

    private void say(Turn turn, String what, UnaryOperator<String> painted) {
        streams.out().println("turn " + TextFormat.right(Integer.toString(turn.number()), 3) + "  "
            + painted.apply(TextFormat.plain(TextFormat.shorten(what, 90))));
        streams.out().flush();
    }
}
