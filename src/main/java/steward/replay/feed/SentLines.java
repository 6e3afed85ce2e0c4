package steward.replay.feed;

import java.nio.charset.StandardCharsets;
import steward.bot.LineBuffer;
import steward.game.GameTypes;
import steward.match.Dialogue;
import steward.replay.RecordedTurn;
import steward.replay.ReplayHeader;
import steward.replay.ReplayReader;
import steward.replay.verify.Resimulation;

/**
 * Lines that bots were sent in a recorded match. They are not recorded: the game is played again by {@link #match} and
 * gives them; for a guest's referee, its recorded output is used. Buffers are valid until the next call.
 */
public final class SentLines {

    private final Resimulation match;
    private final Dialogue[] dialogues;

    /** @param replay with a header; its turns are the caller's to read */
    public SentLines(ReplayReader replay, GameTypes types) {
        this(replay.header(), new Resimulation(replay.header(), replay.start(), types, replay.source()));
    }

    /** @param match of the header, nothing played yet */
    SentLines(ReplayHeader header, Resimulation match) {
        this.match = match;
        dialogues = new Dialogue[header.names().size()];
        for (int player = 0; player < dialogues.length; player++) {
            dialogues[player] = Dialogue.of(header.protocols().get(player), match.setup(), match.game(),
                match.codec(), header.limits());
        }
    }

    /** The match, which the caller plays turn by turn. */
    public Resimulation match() {
        return match;
    }

    /** The lines before the first turn. */
    public LineBuffer setup(int player) {
        return dialogues[player].setup(player);
    }

    /** The lines of a turn that is still to be played, or {@code null} if the bot was not asked in it. */
    public LineBuffer turn(int player, RecordedTurn turn) {
        return match.game().isAsked(player) && turn.asked(player) ? dialogues[player].turn(player) : null;
    }

    public LineBuffer end(int player) {
        return dialogues[player].end(player);
    }

    /** All that a bot was sent for its answer in a turn that is still to be played, or {@code null}. */
    public String text(int player, RecordedTurn turn) {
        String before = turn.number() == 1 ? text(setup(player)) : "";
        LineBuffer lines = turn(player, turn);
        return lines == null ? null : before + text(lines);
    }

    private static String text(LineBuffer lines) {
        return new String(lines.bytes(), 0, lines.size(), StandardCharsets.UTF_8);
    }
}
