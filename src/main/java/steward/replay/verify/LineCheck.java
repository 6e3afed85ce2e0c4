package steward.replay.verify;

import java.util.List;
import steward.game.Game;
import steward.replay.RecordedTurn;

/** Compares the lines of a replay with a match that is played again; one per format. */
interface LineCheck {

    /** Compares the header, before the first turn; {@code null} if it agrees. */
    Difference header();

    /**
     * Plays the turn of a line that has nothing unusual in it, as nearly all have, without parsing it.
     *
     * @return whether it agrees in every byte; if not, {@link #turn} is to be asked next
     */
    boolean isSame(byte[] line);

    /** Compares a turn, and plays it unless {@link #isSame} has done so; {@code null} if it agrees. */
    Difference turn(byte[] line, RecordedTurn turn);

    /** How the impacts of another referee compare with ours; none where the match is not imported. */
    default ImpactCounts impacts() {
        return ImpactCounts.NONE;
    }

    /** Comparison with what a server has shown; none where the match is not imported. */
    default ViewCounts views() {
        return ViewCounts.NONE;
    }

    /** Compares the result; {@code null} if it agrees. */
    Difference result(String[] faults);

    /** The result is there although the match is not over, or is not that of this match. */
    static Difference end(Game game, int turns, String ending) {
        if (!game.isOver()) {
            return new Difference(game.turn(), "result", "an end of the match", "the match goes on");
        }
        if (turns != game.turn()) {
            return new Difference(game.turn(), "turns", Integer.toString(turns), Integer.toString(game.turn()));
        }
        return ending.equals(game.ending()) ? null : new Difference(game.turn(), "ending", ending, game.ending());
    }

    /** Names and faults of the result are those of the header and the turns. */
    static Difference players(int turn, List<String> names, String[] faults, String[] recordedNames,
                              String[] recordedFaults) {
        if (recordedNames.length != names.size()) {
            return new Difference(turn, "players", recordedNames.length + " entries", names.size() + " entries");
        }
        for (int player = 0; player < faults.length; player++) {
            String field = "players[" + player + "].";
            if (!names.get(player).equals(recordedNames[player])) {
                return new Difference(turn, field + "name", String.valueOf(recordedNames[player]), names.get(player));
            }
            if (!said(faults[player]).equals(said(recordedFaults[player]))) {
                return new Difference(turn, field + "fault", said(recordedFaults[player]), said(faults[player]));
            }
        }
        return null;
    }

    private static String said(String fault) {
        return fault == null ? "nothing" : fault;
    }
}
