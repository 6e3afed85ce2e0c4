package steward.guest;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.TimeUnit;
import java.util.function.Supplier;
import steward.bot.Answer;
import steward.bot.Player;
import steward.bot.command.Program;
import steward.bot.isolation.Isolation;
import steward.bot.isolation.Launch;
import steward.bot.process.BotProcess;
import steward.guest.RefereeBlock.Name;

/**
 * Trial game between idle bots that is played, in full or in part, to learn about a referee.
 *
 * @param said      a hash of all that was said in each kind of block
 * @param questions that were answered
 * @param whole     whether the game came to its end
 */
record TrialGame(Map<Name, Long> said, int questions, boolean whole) {

    private static final String IDLE = "WAIT";
    /** Milliseconds for an answer of a bot, its start included. */
    private static final long PATIENCE_MS = 10_000;
    /** Milliseconds after its first question in which a game has to show what there is to see. */
    private static final long SHOWN_MS = 800;
    /** Milliseconds in which it has to show at least the beginning, where referee or machine are slow. */
    private static final long MOST_MS = 2_400;
    private static final int BEGINNING = 40;

    /** The most questions of a game where the time alone bounds it. */
    static final int ANY = Integer.MAX_VALUE;

    /**
     * Plays a game between idle bots.
     *
     * @param most questions, or {@link #ANY} to play as long as there is time
     * @throws RefereeFault if it fails
     */
    static TrialGame idle(GuestProgram program, int players, long seed, Supplier<Isolation> isolation, int most) {
        GuestGame game = new GuestGame(program, players, seed, isolation, null);
        try {
            return play(game, most, () ->
                game.answer(new ArrayList<>(List.of(IDLE.concat("\n").repeat(game.lines()).split("\n"))), 1));
        } finally {
            game.close();
        }
    }

    private static TrialGame play(GuestGame game, int most, Runnable answer) {
        Map<Name, Long> said = new EnumMap<>(Name.class);
        game.blocks().forEach(block -> add(said, block));
        int questions = 0;
        long began = System.nanoTime();
        for (boolean enough = false; questions < most && !game.isOver() && !enough; questions++) {
            answer.run();
            game.play();
            game.blocks().forEach(block -> add(said, block));
            began = questions == 0 ? System.nanoTime() : began;
            long ms = TimeUnit.NANOSECONDS.toMillis(System.nanoTime() - began);
            enough = most == ANY && (ms > MOST_MS || ms > SHOWN_MS && questions >= BEGINNING);
        }
        return new TrialGame(said, questions, game.isOver());
    }

    /** Plays as much of a game between bots that are all one program. @param most as of {@link #idle} */
    static TrialGame between(Program bot, GuestProgram program, int players, long seed,
                             Supplier<Isolation> isolation, int most) {
        List<Player> bots = new ArrayList<>();
        GuestGame game = new GuestGame(program, players, seed, isolation, null);
        try {
            for (int player = 0; player < players; player++) {
                bots.add(new BotProcess("boss", new Launch(bot, isolation.get().withoutMemoryLimit(), List.of()),
                    BotProcess.DEFAULT_GRACE_MS));
            }
            return play(game, most, () -> ask(game, bots.get(game.asked())));
        } finally {
            bots.forEach(Player::close);
            game.close();
        }
    }

    private static void ask(GuestGame game, Player bot) {
        byte[] frame = game.input(game.asked()).toString().getBytes(StandardCharsets.UTF_8);
        Answer answer = new Answer();
        Player.Ending ending = bot.ask(frame, frame.length, game.lines(), TimeUnit.MILLISECONDS.toNanos(PATIENCE_MS),
            answer);
        if (ending != Player.Ending.ANSWERED || game.refusal(List.of(answer.text().split("\n", -1)), 1) != null) {
            game.eliminate(game.asked(), "failed");
        }
    }

    private static void add(Map<Name, Long> said, RefereeBlock block) {
        said.merge(block.name(), block.lines().hashCode() + 1L, (before, more) -> before * 31 + more);
    }

    /** Blocks in which two games differ. */
    Set<Name> differences(TrialGame other) {
        Set<Name> found = new TreeSet<>();
        for (Name name : Name.values()) {
            if (!said.getOrDefault(name, 0L).equals(other.said.getOrDefault(name, 0L))) {
                found.add(name);
            }
        }
        return found;
    }

    /** Blocks in which any games of two series differ. */
    static Set<Name> differences(List<TrialGame> first, List<TrialGame> second) {
        Set<Name> found = new TreeSet<>();
        for (int game = 0; game < first.size(); game++) {
            found.addAll(first.get(game).differences(second.get(game)));
        }
        return found;
    }
}
