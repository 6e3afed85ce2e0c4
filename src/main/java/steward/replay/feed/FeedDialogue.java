package steward.replay.feed;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import steward.bot.Answer;
import steward.bot.LineBuffer;
import steward.bot.Player;
import steward.json.JsonNumbers;
import steward.match.Dialogue;
import steward.match.Protocol;
import steward.match.SafeText;
import steward.replay.RecordedTurn;
import steward.replay.ReplayException;
import steward.replay.verify.ReplayDifference;
import steward.replay.verify.Resimulation;
import steward.scene.Time;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.ObjectWriteContext;

/**
 * Dialogue with a bot that is sent the lines of one player of a recorded match. The lines are not recorded: the game is
 * played again and gives them. There are no deadlines.
 */
final class FeedDialogue {

    private final Resimulation again;
    private final Dialogue dialogue;
    private final int player;
    private final Player bot;
    private final Answer answer = new Answer();
    private final LineBuffer command = new LineBuffer();
    /** Stays open across commands; opening one for each would cost time. */
    private final JsonGenerator out = JsonNumbers.FACTORY.createGenerator(ObjectWriteContext.empty(), command);
    private boolean started;

    /**
     * A dialogue that has not begun.
     *
     * @param limits of players that had their own, which they were told
     * @throws IllegalArgumentException if the game does not speak the protocol
     */
    FeedDialogue(Resimulation again, int player, Protocol protocol, Player bot, Map<Integer, Time> limits) {
        this.again = again;
        dialogue = Dialogue.of(protocol, again.setup(), again.game(), again.codec(), limits);
        this.player = player;
        this.bot = bot;
    }

    Resimulation again() {
        return again;
    }

    int player() {
        return player;
    }

    /** Time and stderr of the last answer. */
    Answer answer() {
        return answer;
    }

    /** The message that came with the last answer, or {@code null}. */
    String message() {
        return dialogue.message(player);
    }

    /** True if the player is to be asked in the next turn. */
    boolean isIn() {
        return again.game().isAsked(player);
    }

    /**
     * Sends the next turn and compares the answer with the recorded one. A valid answer is then the player's command
     * until another one is read.
     */
    FedTurn ask(RecordedTurn recorded, boolean replaced) {
        if (!started) {
            LineBuffer setup = dialogue.setup(player);
            bot.tell(setup.bytes(), setup.size());
            started = true;
        }
        LineBuffer frame = dialogue.turn(player);
        Player.Ending ending = bot.ask(frame.bytes(), frame.size(), dialogue.answerLines(player), Long.MAX_VALUE,
            answer);
        boolean gone = ending != Player.Ending.ANSWERED;
        boolean none = recorded.faults()[player] != null || replaced && !recorded.hasCommand(player);
        again.codec().clearCommand(player);
        String fault = gone ? answer.fault() : read();
        List<ReplayDifference> differences = none || fault == null && isRecorded(recorded) ? List.of()
            : differences(recorded, fault, gone);
        return new FedTurn(recorded.number(), replaced, fault, recorded.faults()[player], differences, gone);
    }

    /** True if the command of the answer is recorded as this program writes it. */
    private boolean isRecorded(RecordedTurn recorded) {
        writeCommand();
        return recorded.hasCommand(player, command.bytes(), command.size());
    }

    /** Reads also the recorded command, and then the answer once more, whose command counts. */
    private List<ReplayDifference> differences(RecordedTurn recorded, String fault, boolean gone) {
        byte[] now = fault == null ? command() : null;
        byte[] then = recordedCommand(recorded);
        again.codec().clearCommand(player);
        if (!gone) {
            read();
        }
        return fault != null || Arrays.equals(then, now) ? List.of()
            : ReplayDifference.all(recorded.number(), "command", then, now);
    }

    private String read() {
        String wrong = dialogue.readAnswer(player, answer.bytes(), answer.length());
        return wrong == null ? null : SafeText.fault(wrong, answer.bytes(), answer.length());
    }

    /** The recorded command in the form that this program writes. */
    private byte[] recordedCommand(RecordedTurn recorded) {
        String wrong = again.readCommand(recorded, player);
        if (wrong != null) {
            throw new ReplayException(wrong);
        }
        return command();
    }

    /** The player's command as it stands. */
    private byte[] command() {
        writeCommand();
        return Arrays.copyOf(command.bytes(), command.size());
    }

    private void writeCommand() {
        command.reset();
        again.codec().writeCommand(out, player);
        out.flush();
    }

    /** Sends the last lines, if the bot was sent any lines. */
    void end() {
        LineBuffer end = dialogue.end(player);
        bot.finish(end.bytes(), end.size());
    }
}
