package steward.contest;

import java.io.OutputStream;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import steward.Internal;
import steward.bot.Player;
import steward.bot.TimeBasis;
import steward.bot.command.BotCommand;
import steward.bot.command.Program;
import steward.bot.hold.HoldPolicy;
import steward.bot.isolation.HoldMeans;
import steward.bot.isolation.Isolation;
import steward.files.InputException;
import steward.game.GameSetup;
import steward.match.GuestSetup;
import steward.match.MatchListener;
import steward.match.MatchResult;
import steward.match.OwnLimits;
import steward.match.Protocol;
import steward.match.TimeControl;
import steward.replay.sign.SigningKey;
import steward.scene.Time;
import steward.text.TextFormat;

/**
 * A scene and the checked bots that play in it. Any number of matches can be played, also at the same time.
 * Over 400 lines, because half of the class are checks and accessors of one record.
 *
 * @param setup      the scene with its game
 * @param entrants   the bots, in the order of the call: as many as a game has players, or any number in a scene for one
 *                   player, where each plays alone
 * @param time       how long they may take
 * @param timeFactor by which the scene's limits are multiplied; {@code POSITIVE_INFINITY} for no deadlines
 * @param staging    starts bots, writes replays and signs them
 */
public record Contest(GameSetup setup, List<Entrant> entrants, TimeControl time, double timeFactor,
                      @Internal Staging staging) {

    /** A contest whose matches are staged so. */
    @Internal
    public Contest {
    }

    /** A contest whose replays are not signed, with the usual isolation. */
    public Contest(GameSetup setup, List<Entrant> entrants, TimeControl time, double timeFactor) {
        this(setup, entrants, time, timeFactor, Staging.USUAL);
    }

    @Internal
    public Contest signedWith(SigningKey key) {
        return new Contest(setup, entrants, time, timeFactor, staging.signedWith(key));
    }

    public Contest between(List<Entrant> others) {
        return new Contest(setup, others, time, timeFactor, staging);
    }

    /** Returns this contest with bots kept apart in another way. */
    @Internal
    public Contest isolatedBy(Supplier<Isolation> other) {
        GameSetup kept = setup instanceof GuestSetup guest ? guest.isolatedBy(other) : setup;
        return new Contest(kept, entrants, time, timeFactor, staging.isolatedBy(other));
    }

    /** Returns this contest with bots that are started in another way: in this JVM, to measure without processes. */
    @Internal
    public Contest startedBy(BotStarter other) {
        return new Contest(setup, entrants, time, timeFactor, staging.startedBy(other));
    }

    /** A copy with some of the bots held from their first answer on. */
    @Internal
    public Contest holding(Collection<Entrant> held) {
        return startedBy((entrant, usual, others) -> staging.starter().player(entrant,
            held.contains(entrant) ? usual.holding(HoldPolicy.ALWAYS) : usual, others));
    }

    /** The level at which bots are started, {@code off}, {@code light} or {@code strict}. */
    public String sandbox() {
        return staging.isolation().get().level().word();
    }

    /**
     * Treatment of bots that compute while others are asked, as {@code waiting bots are stopped by control groups};
     * empty if nothing is.
     */
    @Internal
    public String hold() {
        return timeFactor == Double.POSITIVE_INFINITY ? "" : HoldMeans.text(staging.isolation().get());
    }

    /** Returns this contest with limits on another clock. */
    public Contest limitedBy(TimeBasis basis) {
        return limitedBy(time.by(basis));
    }

    /** Returns this contest with other limits, which its factor does not tell. */
    public Contest limitedBy(TimeControl limits) {
        return new Contest(setup, entrants, limits, timeFactor, staging);
    }

    /** Returns this contest with bots that have limits of their own, by their names; other names are passed over. */
    @Internal
    public Contest limitedBy(Map<String, OwnLimits> own) {
        return between(entrants.stream().map(each -> own.containsKey(each.name()) ? each.within(own.get(each.name()))
            : each).toList());
    }

    /** The limits in this scene of bots that have their own, by their places in the list. */
    @Internal
    public Map<Integer, Time> limits(List<Entrant> seated) {
        Map<Integer, Time> limits = new HashMap<>();
        for (int player = 0; player < seated.size(); player++) {
            if (seated.get(player).limits() != null) {
                limits.put(player, seated.get(player).limits().in(setup.scene().time()));
            }
        }
        return limits;
    }

    /**
     * A bot.
     *
     * @param name     unlike the others' names
     * @param bot      as it was named in the call
     * @param protocol the language it speaks
     * @param program  what is started, and where
     * @param problem  why it cannot be started, or {@code null}
     * @param limits   of its own, or {@code null} for those of the scene
     */
    public record Entrant(String name, String bot, Protocol protocol, @Internal Program program, String problem,
                          @Internal OwnLimits limits) {

        private static final Pattern BUILTIN =
            Pattern.compile("([^=\\s]*=)?" + BotCommand.Prefix.BUILTIN.written() + ".*");

        /** One that can be started, as far as is known, in the current folder. */
        public Entrant(String name, String bot, Protocol protocol, List<String> words) {
            this(name, bot, protocol, Program.here(words), null);
        }

        /** A bot with a folder and limits of its own. */
        @Internal
        public Entrant {
        }

        /** A bot with a folder of its own, and the limits of the scene. */
        @Internal
        public Entrant(String name, String bot, Protocol protocol, Program program, String problem) {
            this(name, bot, protocol, program, problem, null);
        }

        /** The program to start and its arguments. */
        public List<String> words() {
            return program.words();
        }

        /** Returns this entrant under another name. */
        public Entrant named(String other) {
            return new Entrant(other, bot, protocol, program, problem, limits);
        }

        /** Returns this entrant with limits of its own, or those of the scene for {@code null}. */
        @Internal
        public Entrant within(OwnLimits other) {
            return new Entrant(name, bot, protocol, program, problem, other);
        }

        /** Builtin bots run in a JVM, which ends at once under a limit of addresses that suits a bot of strangers. */
        boolean isBuiltin() {
            return BUILTIN.matcher(bot).matches();
        }
    }

    /**
     * Finds the bots; nothing is started.
     *
     * @param usual the protocol of bots without a prefix
     * @throws InputException if the bots are not as many as the players, one cannot be started, or the scene does not
     *                        have its protocol
     */
    public static Contest of(GameSetup setup, List<String> bots, Protocol usual, double timeFactor) {
        return of(setup, bots, here(bots), usual, timeFactor);
    }

    /** Makes a contest as {@link #of(GameSetup, List, Protocol, double)} does; each bot has a folder of its own. */
    @Internal
    public static Contest of(GameSetup setup, List<String> bots, List<Path> folders, Protocol usual,
                             double timeFactor) {
        refuseOtherNumber(setup, bots);
        return withoutProblem(create(setup, bots, folders, usual, timeFactor));
    }

    private static List<Path> here(List<String> bots) {
        return Collections.nCopies(bots.size(), Path.of(""));
    }

    /**
     * Makes a contest as {@link #of} does, for a series: in a scene for one player any number of bots can each play
     * alone.
     */
    public static Contest ofSeries(GameSetup setup, List<String> bots, Protocol usual, double timeFactor) {
        return ofSeries(setup, bots, here(bots), usual, timeFactor);
    }

    /** Makes a contest for a series; each bot has a folder of its own. */
    @Internal
    public static Contest ofSeries(GameSetup setup, List<String> bots, List<Path> folders, Protocol usual,
                                   double timeFactor) {
        return setup.scene().players() > 1 || bots.isEmpty() ? of(setup, bots, folders, usual, timeFactor)
            : withoutProblem(create(setup, bots, folders, usual, timeFactor));
    }

    private static Contest withoutProblem(Contest contest) {
        for (Entrant entrant : contest.entrants()) {
            if (entrant.problem() != null) {
                throw new InputException(entrant.problem());
            }
        }
        return contest;
    }

    /**
     * Makes a contest as {@link #of} does, but a bot that cannot be started takes part, and fails when it is asked for
     * the first time: for tools that let the other bots play on.
     */
    public static Contest withFailing(GameSetup setup, List<String> bots, Protocol usual, double timeFactor) {
        refuseOtherNumber(setup, bots);
        return create(setup, bots, here(bots), usual, timeFactor);
    }

    private static void refuseOtherNumber(GameSetup setup, List<String> bots) {
        int players = setup.scene().players();
        if (bots.size() != players) {
            throw new InputException("found " + TextFormat.count(bots.size(), "bot") + ", expected "
                + TextFormat.count(players, "bot") + ", one for each player of the scene \"" + setup.scene().name()
                + "\"" + (players != 1 || bots.isEmpty() ? ""
                    : "; in a series of games several bots each play alone on the same maps"));
        }
    }

    private static Contest create(GameSetup setup, List<String> bots, List<Path> folders, Protocol usual,
                                  double timeFactor) {
        List<Entrant> entrants = entrants(bots, folders, setup.isGuest() ? Protocol.CODINGAME : usual);
        checkPlayable(setup, entrants);
        return new Contest(setup, entrants, timeControl(setup, timeFactor), timeFactor);
    }

    /** A contest whose bots are still to come, see {@link #between}. */
    @Internal
    public static Contest withoutBots(GameSetup setup, double timeFactor) {
        return new Contest(setup, List.of(), timeControl(setup, timeFactor), timeFactor);
    }

    private static TimeControl timeControl(GameSetup setup, double factor) {
        return factor == Double.POSITIVE_INFINITY ? TimeControl.UNLIMITED
            : InputException.of(() -> TimeControl.of(setup.scene().time(), factor));
    }

    private static List<Entrant> entrants(List<String> bots, List<Path> folders, Protocol usual) {
        List<Entrant> entrants = new ArrayList<>();
        for (int k = 0; k < bots.size(); k++) {
            entrants.add(entrant(bots.get(k), folders.get(k), null, usual));
        }
        List<String> names = FolderNames.of(entrants);
        for (int k = 0; k < bots.size(); k++) {
            entrants.set(k, entrants.get(k).named(unlikeOthers(names, k)));
        }
        return entrants;
    }

    /** A bot by itself, as it is named in a call; one that cannot be started has the problem. */
    @Internal
    public static Entrant entrant(String bot, Protocol usual) {
        return entrant(bot, Path.of(""), null, usual);
    }

    /**
     * A bot by itself with a folder of its own; one that cannot be started has the problem.
     *
     * @param files see {@link Program}
     */
    @Internal
    public static Entrant entrant(String bot, Path folder, List<String> files, Protocol usual) {
        BotCommand command;
        try {
            command = BotCommand.parse(bot, usual == Protocol.JSON ? BotCommand.Prefix.JSON
                : BotCommand.Prefix.CODINGAME);
        } catch (IllegalArgumentException problem) {
            return new Entrant(bot.isBlank() ? "nobody" : bot, bot, usual, Program.here(List.of()),
                problem.getMessage());
        }
        Protocol spoken = command.prefix() == BotCommand.Prefix.CODINGAME ? Protocol.CODINGAME : Protocol.JSON;
        String name = command.displayName(folder);
        boolean bundled = command.prefix() == BotCommand.Prefix.BUILTIN && files == null;
        try {
            return new Entrant(name, command.toString(), spoken, new Program(command.resolve(folder), folder,
                bundled ? List.of() : files), null);
        } catch (IllegalArgumentException problem) {
            return new Entrant(name, command.toString(), spoken, Program.here(List.of()), problem.getMessage());
        }
    }

    /** The bot's own name, or with its number where several have it, or where that would be another's. */
    private static String unlikeOthers(List<String> names, int k) {
        String name = names.get(k);
        if (names.indexOf(name) == names.lastIndexOf(name)) {
            return name;
        }
        String numbered = name + "-" + k;
        while (names.contains(numbered)) {
            numbered += "-" + k;
        }
        return numbered;
    }

    /** Refuses bots whose protocol the scene's game does not support, and builtin bots of other games. */
    public static void checkPlayable(GameSetup setup, List<Entrant> entrants) {
        for (Entrant entrant : entrants) {
            if (entrant.protocol() == Protocol.JSON && setup.isGuest()) {
                throw new InputException("bot '" + entrant.bot() + "': the scene \"" + setup.scene().name()
                    + "\" has a referee of its own, expected a bot that speaks its lines, codingame");
            }
            if (entrant.protocol() == Protocol.CODINGAME && !hasText(setup)) {
                throw new InputException("bot '" + entrant.bot() + "': the scene \"" + setup.scene().name()
                    + "\" has no codingame protocol, expected a bot that speaks json");
            }
            if (entrant.problem() == null) {
                try {
                    BotCommand.parse(entrant.bot()).checkPlays(setup.scene().gameId());
                } catch (IllegalArgumentException problem) {
                    throw new InputException(problem.getMessage());
                }
            }
        }
    }

    static boolean hasText(GameSetup setup) {
        return setup.textCodec(setup.create(0)).isPresent();
    }

    /** True if the scene's game speaks CodinGame's lines too; all games speak JSON. */
    boolean hasBothProtocols() {
        return !setup.isGuest() && hasText(setup);
    }

    /** The number of players of a game: that of the bots, or 1 where each of them plays alone. */
    public int players() {
        return setup.scene().players();
    }

    /** True if each bot plays alone, and results on the same map are compared. */
    public boolean isAlone() {
        return players() == 1;
    }

    /** True if lower scores are better in this game. */
    public boolean lowerScoreIsBetter() {
        return setup.create(0).lowerScoreIsBetter();
    }

    public String sceneName() {
        return setup.scene().name();
    }

    /**
     * Returns which bot plays as a player when the bots have moved up by {@code rotation} places. Where each plays
     * alone, the bots take turns so.
     */
    public int entrantOf(int player, int rotation) {
        return (player + rotation) % entrants.size();
    }

    /**
     * Plays a match.
     *
     * @param rotation  by how many places the bots move up
     * @param recording where the replay goes, or {@code null}; left open
     * @param follower  is told of every turn after it has been recorded
     * @throws RuntimeException if it could not be brought to a result
     */
    public MatchResult play(long seed, int rotation, OutputStream recording, MatchListener follower)
            throws InterruptedException {
        return staging.play(this, IntStream.range(0, players())
            .mapToObj(player -> entrants.get(entrantOf(player, rotation))).toList(), seed, recording, follower);
    }

    /** A bot by itself, not started yet, kept apart as in a match: to be asked again what it was asked. */
    @Internal
    public Player player(Entrant entrant) {
        return staging.player(entrant, List.of());
    }
}
