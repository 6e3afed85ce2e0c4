package steward.codingame.recording;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import steward.bot.Answer;
import steward.bot.Player;
import steward.game.Game;
import steward.game.GameSetup;
import steward.game.GameTypes;
import steward.game.ServerView;
import steward.game.ViewWriter;
import steward.match.GuestSetup;
import steward.replay.ServerRecording;
import tools.jackson.databind.JsonNode;

/**
 * CodinGame's own JSON of a game whose referee its authors have published. Our scene of that referee asks as the
 * server's has asked, and each frame has the answer to the question before it; so who has answered which question is
 * counted, and nothing of it has to be in the file. Who was asked and has no lines there has timed out.
 */
final class GuestGameImport implements RecordingImport, ImportedMatch.Frames {

    private static final String KEY_FRAME = "KEY_FRAME";
    private static final String OTHER_FRAME = "INTERMEDIATE_FRAME";

    private final ServerFrames frames;
    private final GameSetup setup;
    private final ViewWriter views;
    private final long seed;
    private final ServerRecording.End end;
    private final RecordingFacts facts;
    /** Per player the numbers of the frames with its answers. */
    private final List<List<Integer>> answers = new ArrayList<>();
    /** Times of answers in milliseconds, and those after which they are late, by the numbers of the frames. */
    private final int[] told;
    private final int[] lateMs;
    /** Views of our referee, and the times of the play that is under way. */
    private final List<String> ours = new ArrayList<>();
    private Game game;
    private int[] playing;
    /** Frames that our referee has said so far. */
    private int heard;
    private String note;

    private GuestGameImport(JsonNode result, String source, GameTypes types, GuestSetup scene) {
        frames = new ServerFrames(result, source);
        frames.requireStart();
        int players = scene.scene().players();
        int found = Math.max(frames.players(), Math.max(result.path("agents").size(), result.path("scores").size()));
        if (found != players && (found > players || result.path("agents").size() > 0)) {
            throw new IllegalArgumentException(source + ": found " + found + " players, expected " + players
                + ", as many as the scene \"" + scene.scene().name() + "\" is for");
        }
        String input = frames.input();
        ServerView.Start start;
        try {
            start = scene.begin(input.lines().toList());
        } catch (IllegalArgumentException problem) {
            throw new IllegalArgumentException(source + ": refereeInput: " + problem.getMessage());
        }
        seed = start.seed();
        setup = start.scene().equals(scene.scene().json()) ? scene : types.open(start.scene(),
            scene.scene().root().source());
        views = types.viewWriter(setup.scene().gameId()).orElseThrow();
        double[] scores = frames.scores(players);
        int[] ranks = frames.ranks(players);
        end = new ServerRecording.End(0, List.of(),
            ServerGameImport.words(IntStream.of(ranks).mapToObj(Integer::toString)),
            ServerGameImport.words(DoubleStream.of(scores).mapToObj(Double::toString)),
            input.lines().map(String::strip).filter(line -> !line.isEmpty()).sorted()
                .collect(Collectors.joining("\n")), result.path("metadata").asString(null));
        facts = frames.facts(players);
        told = new int[frames.size()];
        lateMs = new int[told.length];
        for (int player = 0; player < players; player++) {
            answers.add(new ArrayList<>());
        }
    }

    /**
     * Reads a recording.
     *
     * @param scene of the referee, at the level at which it is to be played
     * @throws IllegalArgumentException if no game of the scene can be played so
     */
    static GuestGameImport of(JsonNode gameResult, String source, GameTypes types, GuestSetup scene) {
        return new GuestGameImport(gameResult, source, types, scene);
    }

    @Override
    public Imported write(OutputStream out) throws InterruptedException {
        ByteArrayOutputStream replay = new ByteArrayOutputStream();
        Imported imported = play(told, replay);
        if (IntStream.of(lateMs).anyMatch(ms -> ms > 0) && !isShown()) {
            readTimes();
            replay.reset();
            imported = play(told, replay);
        }
        try {
            replay.writeTo(out);
        } catch (IOException problem) {
            throw new UncheckedIOException(problem);
        }
        return imported;
    }

    private Imported play(int[] times, OutputStream out) throws InterruptedException {
        heard = 0;
        note = null;
        ours.clear();
        answers.forEach(List::clear);
        playing = times;
        List<Player> players = new ArrayList<>();
        for (int player = 0; player < setup.scene().players(); player++) {
            players.add(new Recorded(player));
        }
        Imported imported = new ImportedMatch(setup, seed, this, end, facts, players).write(out);
        return new Imported(imported.turns(), imported.ending(), note);
    }

    private boolean isShown() {
        return ShownTimes.read(ours, ours, recorded(), new int[0], new int[0]) < 0;
    }

    /** The recorded views, in the form of ours. */
    private List<String> recorded() {
        return shown(0, frames.size()).stream().map(frame -> frame.view() == null ? null
            : frame.view().stripTrailing()).toList();
    }

    /** Takes the times of answers from the recorded views. If those differ otherwise, a player may have been late. */
    private void readTimes() throws InterruptedException {
        int equal = -1;
        int suspect = 0;
        int[] best = told.clone();
        while (suspect <= answers.size()) {
            play(told, OutputStream.nullOutputStream());
            List<String> plain = List.copyOf(ours);
            int[] probes = ShownTimes.probes(told, lateMs);
            play(probes, OutputStream.nullOutputStream());
            int differs = ShownTimes.read(plain, List.copyOf(ours), recorded(), told, probes);
            if (differs < 0) {
                return;
            }
            if (differs > equal) {                     // with these times it may come further
                equal = differs;
                best = told.clone();
                suspect = 0;
                continue;
            }
            boolean supposed = false;
            for (; suspect < answers.size() && !supposed; suspect++) {
                System.arraycopy(best, 0, told, 0, told.length);
                supposed = ShownTimes.supposeLate(before(equal, answers.get(suspect)), told, lateMs);
            }
            suspect += supposed ? 0 : 1;
        }
        System.arraycopy(best, 0, told, 0, told.length);
    }

    private static List<Integer> before(int frame, List<Integer> answers) {
        return answers.stream().filter(answer -> answer <= frame).toList();
    }

    @Override
    public boolean has(int turn) {
        return true;
    }

    @Override
    public List<ServerRecording.Frame> of(int turn, Game played) {
        if (turn == 0) {
            game = played;
            views.begin(game);
        } else {
            views.before();
        }
        int from = heard;
        heard += views.frames();
        for (int k = 0; k < views.frames(); k++) {
            List<String> view = views.answer(k).view();
            ours.add(view == null ? "" : String.join("\n", view));
        }
        // The first of the others of a turn answers its question; those behind it were asked of nobody.
        for (int frame = Math.max(1, from + (turn == 0 ? 0 : 1)); frame < heard && frame < frames.size(); frame++) {
            if (!lines(frame).isEmpty() && !lines(frame).equals(List.of("")) && note == null) {
                note = "frame " + frame + " has an answer of a player who has failed: it is not asked again here";
            }
        }
        return shown(from, heard);
    }

    @Override
    public List<ServerRecording.Frame> behind(int turn) {
        return shown(heard, frames.size());
    }

    private List<ServerRecording.Frame> shown(int from, int to) {
        List<ServerRecording.Frame> shown = new ArrayList<>();
        for (int frame = from; frame < Math.min(to, frames.size()); frame++) {
            ServerRecording.Frame of = frames.shown(frame, false);
            boolean plain = of.view() == null || of.view().startsWith(KEY_FRAME) || of.view().startsWith(OTHER_FRAME);
            shown.add(new ServerRecording.Frame(plain ? of.view() : (frames.endsTurn(frame, false) ? KEY_FRAME
                : OTHER_FRAME) + " " + of.view().stripLeading(), of.summary(), null, of.tooltips(), false));
        }
        return shown;
    }

    /** The lines of an answer, empty ones too; none if there is no answer. */
    private List<String> lines(int frame) {
        String stdout = frames.text(frame, "stdout");
        return stdout == null || stdout.isEmpty() ? List.of()
            : Arrays.asList(stdout.replaceFirst("\r?\n$", "").split("\r?\n", -1));
    }

    /** Says what a player has said in the frame that answers the question. */
    private final class Recorded implements Player {

        private final int number;

        Recorded(int number) {
            this.number = number;
        }

        @Override
        public String name() {
            return facts.names().get(number);
        }

        @Override
        public Ending ask(byte[] frame, int length, int answerLines, long limitNanos, Answer answer) {
            if (heard >= frames.size()) {
                throw new ImportedMatch.RecordingEnds();
            }
            int of = frames.agent(heard, number);
            if (of >= 0 && of != number) {
                note = "frame " + heard + " is of player " + of + ", but here player " + number + " is asked";
                throw new ImportedMatch.RecordingEnds();
            }
            answers.get(number).add(heard);
            lateMs[heard] = game.strikeMs(number);
            answer.clear();
            answer.setNanos(TimeUnit.MILLISECONDS.toNanos(playing[heard]));
            answer.setStderr(frames.text(heard, "stderr"));
            return RecordedPlayer.say(lines(heard), answerLines, answer);
        }
    }
}
