package steward.league.play;

import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.stream.IntStream;
import steward.bot.command.Platform;
import steward.contest.Contest.Entrant;
import steward.files.InputException;
import steward.league.LeagueBot;
import steward.league.LeagueSettings;
import steward.league.store.GameStore.Version;
import steward.text.TextFormat;

/**
 * The bots that play in a league at the moment.
 *
 * @param settings where they are named
 * @param members  in the order of the file
 */
public record Roster(LeagueSettings settings, List<Member> members) {

    /**
     * A bot that plays.
     *
     * @param bot     as the file names it
     * @param version which program it is
     * @param entrant how it is started
     * @param stamp   changes when one of its files does
     * @param unsteady the file by which it has become another version too often, or {@code null}
     */
    public record Member(LeagueBot bot, Version version, Entrant entrant, String stamp, String unsteady) {

        /** True if it may be started on this machine: it is not for another platform. */
        public boolean playsHere() {
            return bot.playsOn(Platform.here());
        }

        /** Says that it is paused, and why. @param failures in a row that pause a bot */
        String whyPaused(int failures, Path league) {
            return version.display() + " is paused: " + (unsteady != null ? unsteady + " has made a third version of "
                + "it within " + RosterReader.STEADY + " games, and at --sandbox off a bot can write to its own files; "
                : "it failed in " + failures + " games in a row; 'steward league games " + league + " --failed' says "
                + "how, ") + "'steward league resume " + league + " " + bot.name() + "' lets it play again";
        }
    }

    public Roster {
        members = List.copyOf(members);
    }

    /** The numbers of their versions. */
    public List<Integer> versions() {
        return members.stream().map(member -> member.version().id()).toList();
    }

    /** The members by the number of their version. */
    public Map<Integer, Member> byVersion() {
        Map<Integer, Member> members = new HashMap<>();
        this.members.forEach(member -> members.put(member.version().id(), member));
        return members;
    }

    public Optional<Integer> versionOf(String name) {
        return members.stream().filter(member -> member.bot().name().equals(name))
            .map(member -> member.version().id()).findFirst();
    }

    /** Returns which versions may play together: those for one platform do not meet those for another. */
    public Predicate<int[]> meeting() {
        Map<Integer, String> platforms = new HashMap<>();
        members.stream().filter(member -> member.bot().platform() != null).forEach(member ->
            platforms.put(member.version().id(), member.bot().platform()));
        return group -> platforms.isEmpty() || IntStream.of(group).mapToObj(platforms::get).filter(Objects::nonNull)
            .distinct().count() <= 1;
    }

    /** True if two versions may meet in a game of so many players. */
    public boolean isPair(int players, int one, int other) {
        return players == 1 || meeting().test(new int[] {one, other}) && (players > 2 || settings.gauntlet() == null
            || versionOf(settings.gauntlet()).stream().anyMatch(hero -> hero == one || hero == other));
    }

    /** Returns how many bots one platform can have in a game, at most. */
    private long together() {
        return Math.max(members.stream().filter(Member::playsHere).count(), members.stream()
            .map(member -> member.bot().platform()).filter(Objects::nonNull).mapToLong(platform -> members.stream()
                .filter(member -> member.bot().playsOn(platform)).count()).max().orElse(0));
    }

    /**
     * Returns this, unless no game can be played with these bots.
     *
     * @param players of a game
     * @throws InputException if they are too few, or the one of the gauntlet is not among them
     */
    public Roster checked(int players) {
        if (members.size() < players) {
            throw new InputException("found " + TextFormat.count(members.size(), "bot") + " that "
                + (members.size() == 1 ? "plays" : "play") + ", expected at least " + players
                + "; 'steward league add' adds one");
        }
        if (together() < players) {
            throw new InputException("found at most " + TextFormat.count(together(), "bot") + " for any one platform, "
                + "expected at least " + players + " that can play together");
        }
        if (settings.gauntlet() != null && versionOf(settings.gauntlet()).isEmpty()) {
            throw new InputException("pairing: the bot '" + settings.gauntlet() + "' of the gauntlet is retired, "
                + "expected one that plays");
        }
        return this;
    }
}
