package steward.league.play;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import steward.bot.command.BotCommand;
import steward.bot.command.Platform;
import steward.bot.isolation.SandboxLevel;
import steward.contest.Contest;
import steward.contest.Contest.Entrant;
import steward.contest.ProgramWatch;
import steward.files.InputException;
import steward.league.BotIdentity;
import steward.league.LeagueBot;
import steward.league.LeagueSettings;
import steward.league.store.GameStore;
import steward.league.store.GameStore.Version;
import steward.match.OwnLimits;
import steward.text.TextFormat;

/**
 * Reader of the roster: which program each bot is, and a new version for a bot whose program has changed. Not
 * thread-safe.
 */
public final class RosterReader {

    /** A third version within so many games of a bot pauses it where a bot could have made it itself. */
    static final int STEADY = 20;

    private static final String HERE = Platform.here();

    private final GameStore store;
    private final Contest contest;
    private final BotIdentity identity;
    private final boolean same;
    private final Consumer<String> teller;
    private final LongSupplier clock;
    /** Stamps of bots as they were read last, by name. */
    private final Map<String, String> known = new HashMap<>();
    /** Bots that became other versions too often, by name. */
    private final Map<String, Unsteady> unsteady = new HashMap<>();

    /**
     * A bot that became another version too often.
     *
     * @param file    by which it did
     * @param resumed as it was set then: another value lets it play
     */
    private record Unsteady(String file, int resumed) { }

    /**
     * @param contest of the scene; its own bots do not matter
     * @param same    whether a changed program is the same version all the same
     * @param teller  is told what has changed
     * @param clock   milliseconds since 1970
     */
    public RosterReader(GameStore store, Contest contest, Map<String, String> environment, boolean same,
                        Consumer<String> teller, LongSupplier clock) {
        this.store = store;
        this.contest = contest;
        identity = new BotIdentity(environment);
        this.same = same;
        this.teller = teller;
        this.clock = clock;
    }

    /**
     * Reads the bots that play.
     *
     * @throws InputException if one cannot be started, two have the same program, or they are too few
     */
    public Roster read(LeagueSettings settings) {
        List<LeagueBot> active = settings.active();
        // Before the files are read: what is written meanwhile is seen as a change.
        List<String> stamps = active.stream().map(identity::stamp).toList();
        List<Entrant> entrants = new ArrayList<>();
        for (LeagueBot bot : active) {
            Entrant entrant = bot.on(HERE).entrant();
            if (entrant.problem() != null && bot.playsOn(HERE)) {
                throw new InputException(entrant.problem() + (bot.folder() != null
                    || !entrant.problem().contains("there is no file") ? ""
                        : "; run the league from the folder in which it was added, or add it anew"));
            }
            entrants.add(entrant);
        }
        Map<LeagueBot, String> identities = identities(active);
        Contest.checkPlayable(contest.setup(), entrants);
        List<Roster.Member> members = new ArrayList<>();
        for (int k = 0; k < active.size(); k++) {
            LeagueBot bot = active.get(k);
            Version version = version(settings, bot, identities.get(bot));
            Unsteady found = unsteady.get(bot.name());
            members.add(new Roster.Member(bot, version, entrants.get(k).named(version.display()), stamps.get(k),
                found != null && found.resumed() == bot.resumed() ? found.file() : null));
            known.put(bot.name(), stamps.get(k));
        }
        return new Roster(settings, members);
    }

    /** Returns a stamp of the bot's program, which changes when the program may be another; no file is read. */
    public String stamp(LeagueBot bot) {
        return identity.stamp(bot);
    }

    /** The programs of bots, those for other platforms too, to be watched. */
    static ProgramWatch watch(LeagueSettings settings, Consumer<String> teller) {
        List<ProgramWatch.Watched> programs = new ArrayList<>();
        for (LeagueBot bot : settings.active()) {
            if (bot.parsed().prefix() != BotCommand.Prefix.BUILTIN) {
                programs.add(new ProgramWatch.Watched(bot.name(), bot.program(),
                    () -> bot.playsOn(HERE) ? bot.on(HERE).entrant().problem() : null));
            }
            bot.platforms().forEach(each -> programs.add(new ProgramWatch.Watched(bot.name(),
                bot.on(each.platform()).program(), () -> null)));
        }
        return new ProgramWatch(programs, teller);
    }

    /** Games of the two versions before. */
    private long gamesBefore(Version version) {
        return store.versions().stream().filter(each -> each.bot().equals(version.bot())
            && each.number() < version.number() && each.number() >= version.number() - 2)
            .mapToLong(each -> store.gamesOf(each.id())).sum();
    }

    /** The first file of a bot that has been touched since it was read last; otherwise its command. */
    private String changed(LeagueBot bot) {
        List<String> before = known.getOrDefault(bot.name(), "").lines().toList();
        String stamp = identity.stamp(bot);
        return bot.program().paths().stream().map(Path::toString).filter(file -> stamp.lines().anyMatch(line ->
            line.startsWith(file + " ") && !before.contains(line))).findFirst().orElse("its command");
    }

    private Map<LeagueBot, String> identities(List<LeagueBot> active) {
        Map<LeagueBot, String> identities = new HashMap<>();
        Map<String, LeagueBot> owners = new HashMap<>();
        for (LeagueBot bot : active) {
            String hash = identity.of(bot);
            LeagueBot other = owners.putIfAbsent(hash, bot);
            if (other != null) {
                throw sameProgram(other.name(), bot.name());
            }
            identities.put(bot, hash);
        }
        return identities;
    }

    private static InputException sameProgram(String one, String other) {
        return new InputException("found the same program twice, as '" + one + "' and as '" + other
            + "', expected bots that differ in command, environment or files");
    }

    private Version version(LeagueSettings settings, LeagueBot bot, String hash) {
        Optional<Version> known = store.version(hash);
        if (known.isPresent()) {
            Version version = known.get();
            if (version.bot().equals(bot.name())) {
                return bot.random() && !version.random() ? store.markRandom(version) : version;
            }
            if (settings.bot(version.bot()).isPresent()) {
                throw sameProgram(version.bot(), bot.name());
            }
            if (store.present(bot.name()).isPresent()) {
                throw new InputException("bot '" + bot.name() + "': found the program of '" + version.bot()
                    + "', but another program of the name '" + bot.name() + "' has games, expected another name");
            }
            store.rename(version.bot(), bot.name());
            teller.accept(version.bot() + " is now called " + bot.name());
            return store.version(hash).orElseThrow();
        }
        Optional<Version> before = store.present(bot.name());
        if (before.isPresent() && same) {
            store.same(before.get(), hash, clock.getAsLong());
            teller.accept(bot.name() + " changed and counts as " + before.get().display() + " as before");
            return before.get();
        }
        Version version = store.add(bot.name(), bot.command(), OwnLimits.writtenOrNull(bot.limits()),
            bot.random(), hash, clock.getAsLong());
        if (version.number() > 2 && contest.sandbox().equals(SandboxLevel.OFF.word())
                && gamesBefore(version) < STEADY) {
            unsteady.put(bot.name(), new Unsteady(changed(bot), bot.resumed()));
        }
        before.ifPresent(old -> teller.accept(bot.name() + " changed after "
            + TextFormat.count(store.gamesOf(old.id()), "game") + ": new version " + version.display()));
        return version;
    }
}
