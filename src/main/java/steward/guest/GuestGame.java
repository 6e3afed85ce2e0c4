package steward.guest;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Deque;
import java.util.List;
import java.util.Set;
import java.util.function.Supplier;
import java.util.regex.Pattern;
import steward.bot.isolation.Isolation;
import steward.game.AbstractGame;
import steward.game.Game;
import steward.game.TurnEvent;
import steward.guest.RefereeBlock.Name;
import steward.numerics.StateHash;
import steward.physics.Bodies;
import steward.text.TextFormat;

/**
 * Game whose rules are run by an external referee program. A turn is one question: the referee names a player, the
 * number of lines to answer and the limit; the turn passes on that answer, or that there was none. A question for no
 * lines asks nobody and is answered at once; its lines are sent with the next question of that player. A player who has
 * failed is not asked again: the referee is told so each time.
 *
 * <p>The program is started when the game is first asked whose turn it is, and ended by the end of the game or {@link
 * #close}.
 * Over 400 lines, because every block of a referee changes the same state.
 */
final class GuestGame extends AbstractGame {

    /** Size of the field that is drawn. */
    static final int WIDTH = 1600;
    static final int HEIGHT = 900;
    /** Questions of a game at most, those of no lines included: a game that asks more does not end. */
    static final int MOST_QUESTIONS = 20_000;
    /** Characters that a referee may say in a game. */
    private static final long MOST_SAID = 256L << 20;
    private static final int MOST_LINES = 1000;
    private static final int MOST_LIMIT_MS = 3_600_000;
    private static final int BYTES = 8;
    /** Lines for people of a block, and characters of each, that become events. */
    private static final int MOST_LINES_SHOWN = 20;
    private static final int SHOWN = 300;
    /** Characters at which readers of some languages end a line. */
    private static final Pattern ENDS = Pattern.compile("[\\n\\r\\x0b\\x0c\\x1c-\\x1e\\x85\\u2028\\u2029]");
    private static final Pattern PLAYER = Pattern.compile("\\$(\\d)");

    private final GuestProgram program;
    private final long seed;
    private final Supplier<Isolation> isolation;
    private final Supplier<byte[]> recorded;
    private final Deque<RefereeBlock> unsaid = new ArrayDeque<>();
    private final StateHash said = new StateHash();
    private final List<RefereeBlock> blocks = new ArrayList<>();
    private final StringBuilder[] pending;
    private final Bodies bodies = new Bodies(1);
    private final double[] scores;
    private final double[] toldScores;
    private final Expulsions expulsions;
    private RefereeProcess process;
    private boolean opened;
    private boolean closed;
    private boolean monitored;
    private int questions;
    private long length;
    private int player = -1;
    private int lines;
    private int limitMs;
    private List<String> answer;
    private long answerMs;
    private String metadata;

    /** @param recorded start or outcome of the turn that is played; {@code null} where the program is run */
    GuestGame(GuestProgram program, int players, long seed, Supplier<Isolation> isolation, Supplier<byte[]> recorded) {
        super(players);
        this.program = program;
        this.seed = seed;
        this.isolation = isolation;
        this.recorded = recorded;
        scores = new double[players];
        toldScores = new double[players];
        expulsions = new Expulsions(players);
        pending = new StringBuilder[players];
        Arrays.setAll(pending, k -> new StringBuilder());
    }

    private void open() {
        if (opened) {
            return;
        }
        opened = true;
        if (recorded == null) {
            start();
        }
        say(program.beginning(players(), seed));
    }

    private void start() {
        if (program.missing() != null) {
            throw new RefereeFault("cannot be started: found no " + program.missing());
        }
        List<String> command = program.words();
        Isolation isolated = program.isolated(isolation.get());
        synchronized (this) {
            if (closed) {
                throw new RefereeFault("was ended");
            }
            process = program.isResident() ? ResidentReferees.shared().take(command, isolated, program.limitMs())
                : RefereeProcess.start(command, isolated, program.limitMs());
        }
    }

    @Override
    protected void playTurn() {
        open();
        String told = told(answer);
        if (answer != null) {
            expulsions.answered(player, answerMs, strikeMs(player));
        }
        pending[player].setLength(0);
        answer = null;
        blocks.clear();
        say(told);
    }

    /** Returns the block that tells an answer, or that there was none for {@code null}. */
    private String told(List<String> output) {
        if (output == null) {
            return RefereeBlock.text("SET_PLAYER_TIMEOUT", List.of());
        }
        List<String> all = new ArrayList<>(output);
        if (monitored) {
            all.add(0, Long.toString(answerMs));
        }
        return RefereeBlock.text("SET_PLAYER_OUTPUT", all);
    }

    /** Tells the referee this and listens until somebody has to be asked, or the game is over. */
    private void say(String first) {
        String told = first;
        for (;;) {
            hash(told);
            List<RefereeBlock> answered = hear(told);
            answered.forEach(this::take);
            RefereeBlock last = answered.get(answered.size() - 1);
            if (last.name() == Name.SCORES) {
                finish(last);
                return;
            }
            ask(last);
            if (lines > 0 && isIn(player)) {
                return;
            }
            answerMs = 0;
            told = told(lines > 0 ? null : List.of());
        }
    }

    private List<RefereeBlock> hear(String told) {
        if (recorded == null) {
            return process.exchange(told + RefereeBlock.text("GET_GAME_INFO", List.of()));
        }
        if (unsaid.isEmpty()) {
            unsaid.addAll(GuestCodec.said(recorded.get()));
        }
        List<RefereeBlock> said = new ArrayList<>();
        while (said.isEmpty() || !said.get(said.size() - 1).name().isLast()) {
            said.add(unsaid.isEmpty() ? new RefereeBlock(Name.FAIL, List.of()) : unsaid.remove());
        }
        return said;
    }

    private void take(RefereeBlock block) {
        monitored |= block.name() == Name.MONITORING;
        metadata = block.name() == Name.METADATA ? String.join("\n", block.lines()) : metadata;
        if (!program.undetermined().contains(block.name())) {
            blocks.add(block);
            if (block.name() == Name.SUMMARY) {
                expulsions.said(block.lines());
            }
            hash(block.name().name());
            block.lines().forEach(this::hash);
            length += block.lines().stream().mapToInt(String::length).sum();
            if (length > MOST_SAID) {
                throw fault("said more than " + MOST_SAID + " characters in a game");
            }
            // A tooltip is pairs of lines: a text and its player.
            int step = block.name() == Name.SUMMARY ? 1 : block.name() == Name.TOOLTIP ? 2 : MOST_LINES_SHOWN;
            int most = step < MOST_LINES_SHOWN ? Math.min(block.lines().size(), MOST_LINES_SHOWN) : 0;
            for (int k = 0; k < most; k += step) {
                show(block.lines().get(k));
            }
        }
    }

    /** Makes a line for people an event, without colours, and with players by number: the program knows no names. */
    private void show(String line) {
        String text = PLAYER.matcher(Expulsions.COLOUR.matcher(line).replaceAll("")).replaceAll("player $1").strip();
        if (!text.isEmpty()) {
            events.add(TurnEvent.Kind.MARK, 1, -1, WIDTH / 2.0, HEIGHT / 2.0,
                TextFormat.beginning(text, SHOWN), false);
        }
    }

    private void hash(String text) {
        said.add(text.length());
        long word = 0;
        for (int k = 0; k < text.length(); k++) {
            word = word << Short.SIZE | text.charAt(k);
            if (k % (BYTES / 2) == BYTES / 2 - 1) {
                said.add(word);
            }
        }
        said.add(word);
    }

    /** Reads who is asked; the lines that came before are that player's. */
    private void ask(RefereeBlock info) {
        int[] numbers = info.lines().stream().flatMap(line -> List.of(line.trim().split("\\s+")).stream())
            .mapToInt(GuestGame::number).toArray();
        if (numbers.length != 3 || numbers[0] < 0 || numbers[0] >= players() || numbers[1] < 0
                || numbers[1] > MOST_LINES || numbers[2] < 0 || numbers[2] > MOST_LIMIT_MS) {
            throw fault("said NEXT_PLAYER_INFO " + info.lines() + ", expected a player 0.." + (players() - 1)
                + ", a number of lines and a limit in ms");
        }
        if (++questions > MOST_QUESTIONS) {
            throw fault("asked more than " + MOST_QUESTIONS + " times: the game does not end");
        }
        player = numbers[0];
        lines = numbers[1];
        limitMs = Math.max(1, numbers[2]);
        for (int k = blocks.size() - 2; k >= 0 && blocks.get(k).name() == Name.NEXT_PLAYER_INPUT; k--) {
            blocks.get(k).lines().forEach(line -> pending[player].append(line).append('\n'));
        }
    }

    private RefereeFault fault(String problem) {
        return recorded == null ? process.fault(problem) : new RefereeFault(problem);
    }

    private static int number(String word) {
        return word.matches("\\d{1,9}") ? Integer.parseInt(word) : -1;
    }

    private void finish(RefereeBlock told) {
        int found = 0;
        for (String line : told.lines()) {
            String[] words = line.trim().split("\\s+");
            int of = number(words[0]);
            if (words.length == 2 && of >= 0 && of < players() && words[1].matches("-?\\d{1,15}(\\.\\d{1,15})?")) {
                toldScores[of] = Double.parseDouble(words[1]);
                scores[of] = program.tests().score(metadata, toldScores[of]);
                found |= 1 << of;
            }
        }
        if (found != (1 << players()) - 1 || told.lines().size() != players()) {
            throw fault("said SCORES " + told.lines() + ", expected a player and a score in each of "
                + players() + " lines");
        }
        if (questions == 0) {
            throw fault("said SCORES before it asked anybody");
        }
        player = -1;
        end("the referee has ended the game");
        if (recorded != null) {
            return;
        }
        RefereeProcess playing;
        synchronized (this) {
            playing = process;
            process = null;                          // it may play another game, which close() must not end
        }
        if (program.isResident()) {
            ResidentReferees.shared().giveBack(playing);
        } else {
            playing.close();
        }
    }

    @Override
    public synchronized void close() {
        closed = true;
        if (process != null) {
            process.close();
        }
    }

    @Override
    public boolean isAsked(int asked) {
        open();
        return asked == player && isIn(asked);
    }

    @Override
    public int limitMs(int asked) {
        return limitMs;
    }

    @Override
    public int strikeMs(int asked) {
        return monitored && limitMs > Expulsions.STRIKE_EXTRA_MS ? limitMs - Expulsions.STRIKE_EXTRA_MS : 0;
    }

    @Override
    public String expulsion(int player) {
        return isOver() ? expulsions.of(player, scores[player]) : null;
    }

    @Override
    public void timed(int asked, long nanos) {
        answerMs = nanos / 1_000_000;
    }

    /** Lines that the asked player is sent. */
    CharSequence input(int asked) {
        open();
        return pending[asked];
    }

    /** Number of lines of the next answer. */
    int lines() {
        return lines;
    }

    /** The player that is asked, or -1 at the end. */
    int asked() {
        open();
        return player;
    }

    /** Blocks that are not kept, since they differ when a game is played again. */
    Set<Name> undetermined() {
        return program.undetermined();
    }

    /** Scores as the referee has told them: of a game for one, not its criterion. */
    double[] toldScores() {
        return toldScores;
    }

    /** True if times of answers count in the game. */
    boolean isMonitored() {
        return monitored;
    }

    /** The answer of the player that is asked, or {@code null}. */
    List<String> answer() {
        return answer;
    }

    /** Time of that answer, in milliseconds. */
    long answerMs() {
        return answerMs;
    }

    /** Makes lines the answer of the player that is asked, unless they are refused; returns why, or {@code null}. */
    String refusal(List<String> output, long ms) {
        if (output.size() != lines) {
            return "found " + output.size() + " lines, expected " + lines;
        }
        if (output.stream().anyMatch(line -> ENDS.matcher(line).find())) {
            return "found an end of line within a line, expected none";
        }
        answer(output, ms);
        return null;
    }

    /** Makes lines the answer of the player that is asked, or takes it back for {@code null}. */
    void answer(List<String> output, long ms) {
        answer = output;
        answerMs = ms;
    }

    /** All that the referee has said since the last answer. */
    List<RefereeBlock> blocks() {
        open();
        return blocks;
    }

    @Override
    public int[] ranks() {
        return ranks((one, other) -> scores[one] > scores[other]);
    }

    @Override
    public boolean lowerScoreIsBetter() {
        return program.tests().lowerIsBetter();
    }

    @Override
    public double[] scores() {
        return scores.clone();
    }

    @Override
    public Bodies bodies() {
        return bodies;
    }

    @Override
    public Game copy() {
        throw new UnsupportedOperationException("the state of a guest is not known");
    }

    @Override
    public long hash() {
        open();
        return said.value();
    }
}
