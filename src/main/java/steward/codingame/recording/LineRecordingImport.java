package steward.codingame.recording;

import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import steward.bot.Answer;
import steward.bot.Player;
import steward.game.GameSetup;
import steward.game.GameType;
import steward.game.GameTypes;
import steward.match.MatchResult;
import steward.match.Protocol;
import steward.match.Referee;
import steward.match.Seat;
import steward.match.TimeControl;
import steward.replay.ReplayHeader;
import steward.replay.ReplayWriter;
import tools.jackson.databind.JsonNode;

/**
 * Importer of a game for one player that was recorded as lines sent and lines answered:
 * {@code {"stdin":[..], "stdout":[..]}}. Our referee plays the answers, and every line that the server sent is compared
 * with ours while the replay is written. The known games recognise their game and map by the first lines.
 */
record LineRecordingImport(List<String> sent, List<String> answers, GameSetup setup, String source)
    implements RecordingImport {

    static LineRecordingImport of(JsonNode recording, String source, GameTypes types) {
        List<String> sent = lines(recording, "stdin", source);
        List<String> answers = lines(recording, "stdout", source);
        for (GameType type : types.types()) {
            String scene = type.sceneOfLines(sent);
            if (scene != null) {
                return new LineRecordingImport(sent, answers, types.open(scene, source + " (scene)"), source);
            }
        }
        throw new IllegalArgumentException(source + ": stdin: found lines of no game for one player that is known, "
            + "expected those that such a game is sent at its beginning");
    }

    private static List<String> lines(JsonNode recording, String name, String source) {
        List<String> lines = new ArrayList<>();
        for (JsonNode line : recording.get(name)) {
            if (!line.isString()) {
                throw new IllegalArgumentException(source + ": " + name + "[" + lines.size() + "]: found " + line
                    + ", expected a line as a string");
            }
            lines.add(line.stringValue());
        }
        if (lines.isEmpty()) {
            throw new IllegalArgumentException(source + ": " + name + ": found no lines, expected an array of them");
        }
        return lines;
    }

    @Override
    public Imported write(OutputStream out) throws InterruptedException {
        Recorded player = new Recorded();
        ReplayHeader header = new ReplayHeader(setup.scene().gameId(), setup.scene().json(), 0,
            List.of(player.name()), List.of("recorded"), List.of(Protocol.CODINGAME), Double.POSITIVE_INFINITY)
            .ofLaw(setup.plan().lawVersion());
        try {
            MatchResult result = Referee.of(setup, 0, List.of(new Seat(player, Protocol.CODINGAME)),
                TimeControl.UNLIMITED, new ReplayWriter(out, header).untimed()).play();
            if (player.answered < answers.size() || player.heard < sent.size()) {
                throw new DifferentGameException(source + ": found " + answers.size() + " answers and " + sent.size()
                    + " lines, but by these rules the game is over after " + player.answered + " answers: "
                    + result.ending());
            }
            return new Imported(result.turns(), result.ending());
        } catch (ImportedMatch.RecordingEnds end) {
            return new Imported(player.answered, null);
        }
    }

    /** Says what the recorded player has said, and compares what it is told. */
    private final class Recorded implements Player {

        private int heard;
        private int answered;

        @Override
        public String name() {
            return "recorded";
        }

        private void hear(byte[] lines, int length) {
            for (String line : new String(lines, 0, length, StandardCharsets.UTF_8).lines().toList()) {
                String recorded = heard < sent.size() ? sent.get(heard) : null;
                if (!line.equals(recorded)) {
                    throw new DifferentGameException(source + ": stdin[" + heard + "], turn " + (answered + 1)
                        + ": found " + (recorded == null ? "the end" : "\"" + recorded + "\"") + ", by these rules \""
                        + line + "\"");
                }
                heard++;
            }
        }

        @Override
        public void tell(byte[] lines, int length) {
            hear(lines, length);
        }

        @Override
        public Ending ask(byte[] frame, int length, int answerLines, long limitNanos, Answer answer) {
            boolean ends = answered == answers.size();
            if (!ends || heard < sent.size()) {
                hear(frame, length);
            }
            if (ends && heard < sent.size()) {
                throw new DifferentGameException(source + ": stdin[" + heard + "]: found \"" + sent.get(heard)
                    + "\", expected the end: turn " + (answered + 1) + " has no answer");
            }
            if (ends) {
                throw new ImportedMatch.RecordingEnds();
            }
            answer.clear();
            return RecordedPlayer.say(List.of(answers.get(answered++)), 1, answer);
        }
    }
}
