package steward.machines.part;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.HashSet;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.stream.Collectors;
import steward.contest.Contest;
import steward.contest.Contest.Entrant;
import steward.files.InputException;
import steward.game.GameTypes;
import steward.league.GameName;
import steward.league.LeagueBot;
import steward.league.LeagueFolder;
import steward.league.LeagueSettings;
import steward.league.Season;
import steward.league.StoredGame;
import steward.league.StoredGame.StoredSeat;
import steward.league.play.KeptGames;
import steward.league.play.Roster;
import steward.league.play.Roster.Member;
import steward.league.store.GameQueries;
import steward.league.store.GameStore;
import steward.league.store.GameStore.Version;
import steward.league.store.PartStore;
import steward.machines.check.AnswerCheck;
import steward.machines.check.CheckedGame;
import steward.machines.check.DisprovedException;
import steward.machines.check.ExpectedGame;
import steward.machines.check.TranscriptCheck;
import steward.match.Protocol;
import steward.replay.RecordedMatch;

/**
 * Merges parts into a league. The stored facts of a game follow from its transcript, which is played again; of some
 * games the bots are asked again. A part of which anything is wrong is refused as a whole. Merging a part again changes
 * nothing.
 */
public final class PartMerge {

    /** Of a part, the bots of so many games are asked again in any case. */
    private static final int FIRST = 20;
    private static final int TOGETHER = 1000;

    private final GameStore store;
    private final Season season;
    private final int number;
    private final Roster roster;
    private final Contest contest;
    private final double share;
    private final TranscriptCheck transcripts;
    private final AnswerCheck answers;
    private final KeptGames keeper;
    private final Map<Integer, Set<String>> decided = new HashMap<>();

    /**
     * A merge.
     *
     * @param number of the season in the store
     * @param roster the bots as they are now
     * @param share  of the games whose bots are asked again, 0..1; with 0 it is none of the first, either
     */
    public PartMerge(LeagueFolder folder, GameStore store, Season season, int number, Roster roster, Contest contest,
                     GameTypes types, double share) {
        this.store = store;
        this.season = season;
        this.number = number;
        this.roster = roster;
        this.contest = contest;
        this.share = share;
        transcripts = new TranscriptCheck(contest);
        answers = new AnswerCheck(contest, types);
        keeper = new KeptGames(folder);
        new GameQueries(store, number, season).games(game -> decided
            .computeIfAbsent(game.decision(), key -> new HashSet<>()).add(group(game.lineup())));
    }

    /** Returns who meets in a decision: alone each on the same map. */
    private String group(int... lineup) {
        int[] sorted = lineup.clone();
        Arrays.sort(sorted);
        return season.players() == 1 ? "" : Arrays.toString(sorted);
    }

    /**
     * Result of merging a part.
     *
     * @param added  games that are new
     * @param there  games that the league had already
     * @param again  games in which bots were asked again
     */
    public record Merged(int added, int there, int again) {
    }

    /** A game as the part says it, and as it follows from its transcript. */
    private record Checked(StoredGame told, StoredGame own) {
    }

    /**
     * Merges one part.
     *
     * @throws InputException if it does not belong to this league, or anything in it is wrong; nothing of it is stored
     */
    public Merged merge(PartStore part, String source) {
        checkKind(part, source);
        Map<Integer, Version> versions = versions(part, source);
        List<StoredGame> found = new ArrayList<>();
        part.queries().games(found::add);
        checkAttempts(found, part.head(), source);
        SplittableRandom random = new SplittableRandom();
        List<Checked> checked = new ArrayList<>();
        int askedAgain = 0;
        for (StoredGame game : found) {
            if (store.has(named(game, versions))) {
                continue;
            }
            StoredGame own = checked(part, source, game, versions);
            boolean again = share > 0 && game.problem() == null
                && (checked.size() < FIRST || random.nextDouble() < share);
            askedAgain += again && askAgain(part, source, game, versions) ? 1 : 0;
            checked.add(new Checked(game, own));
        }
        int added = 0;
        for (int from = 0; from < checked.size(); from += TOGETHER) {
            List<StoredGame> batch = checked.subList(from, Math.min(checked.size(), from + TOGETHER)).stream()
                .map(game -> kept(part, source, game, versions)).toList();
            added += store.add(number, batch);
        }
        return new Merged(added, found.size() - added, askedAgain);
    }

    private void checkKind(PartStore part, String source) {
        if (!part.season().key().equals(season.key())) {
            throw new InputException(source + ": found a part of another season, expected one of this league's: "
                + season.difference(part.season()));
        }
        LeagueSettings settings = roster.settings();
        if (part.head().seed() != settings.seed()) {
            throw new InputException(source + ": found a part of the seed " + part.head().seed()
                + ", expected the league's, " + settings.seed());
        }
        if (!part.head().pairing().equals(settings.pairing())) {
            throw new InputException(source + ": found a part of the pairing '" + part.head().pairing()
                + "', expected the league's, '" + settings.pairing() + "'");
        }
    }

    /** Of each game of the part one attempt counts, the last one, and no game is from elsewhere. */
    private void checkAttempts(List<StoredGame> games, PartStore.Head head, String source) {
        Map<String, StoredGame> last = new HashMap<>();
        for (StoredGame game : games) {
            if (game.decision() < 0 || game.decision() % head.parts() != head.part() - 1
                || game.seed() != head.seed() + game.decision()) {
                throw new InputException(place(source, game) + ": found decision " + game.decision() + " with the seed "
                    + game.seed() + ", expected a game of part " + head.part() + "/" + head.parts());
            }
            last.merge(game.seed() + Arrays.toString(game.lineup()), game, (one, other) ->
                one.attempt() > other.attempt() ? one : other);
        }
        for (StoredGame game : games) {
            boolean isLast = last.get(game.seed() + Arrays.toString(game.lineup())) == game;
            if (game.counts() != (isLast && game.problem() == null)) {
                throw new InputException(place(source, game) + ": found attempt " + game.attempt() + " that "
                    + (game.counts() ? "counts" : "does not count") + ", expected that the last one counts");
            }
        }
    }

    /** The league's versions by the part's numbers. */
    private Map<Integer, Version> versions(PartStore part, String source) {
        Map<Integer, Version> versions = new HashMap<>();
        for (Version version : part.games().versions()) {
            Optional<Version> own = store.version(version.identity());
            if (own.isEmpty() && part.games().gamesOf(version.id()) == 0) {
                continue;
            }
            versions.put(version.id(), own.orElseThrow(() -> new InputException(source + ": found games of "
                + version.display() + " as another program (" + version.identity() + "), expected "
                + store.present(version.bot()).map(present -> "the league's (" + present.identity() + ")")
                    .orElse("a bot of this league") + ": its command, its files and their paths have to be the same")));
        }
        return versions;
    }

    private byte[] named(StoredGame game, Map<Integer, Version> versions) {
        return GameName.of(season, game.seed(), Arrays.stream(game.lineup())
            .mapToObj(version -> versions.get(version).identity()).toList(), game.attempt());
    }

    /** The game as its transcript tells it. */
    private StoredGame checked(PartStore part, String source, StoredGame game, Map<Integer, Version> versions) {
        String place = place(source, game);
        byte[] name = named(game, versions);
        if (!Arrays.equals(name, game.name())) {
            throw new InputException(place + ": found the name of another game, expected that of its seed, attempt "
                + "and bots, " + HexFormat.of().formatHex(name));
        }
        byte[] transcript = part.transcript(game.id());
        int[] lineup = Arrays.stream(game.lineup()).map(version -> versions.get(version).id()).toArray();
        int decision = decided.getOrDefault(game.decision(), Set.of(group(lineup))).contains(group(lineup))
            && game.seed() == roster.settings().seed() + game.decision() ? game.decision() : -1;
        if (transcript == null) {
            if (game.problem() == null || game.counts()) {
                throw new InputException(place + ": found no transcript, expected that of the game");
            }
            List<StoredSeat> none = Arrays.stream(lineup)
                .mapToObj(version -> new StoredSeat(version, 0, 0, null, 0, 0, 0, 0)).toList();
            return new StoredGame(0, name, decision, game.seed(), game.attempt(), false, 0, game.problem(),
                game.played(), game.machine(), null, none);
        }
        CheckedGame outcome;
        try {
            outcome = transcripts.check(place, transcript, expected(part, game, versions));
        } catch (DisprovedException wrong) {
            throw new InputException(wrong.getMessage());
        }
        List<StoredSeat> seats = new ArrayList<>();
        for (int seat = 0; seat < lineup.length; seat++) {
            CheckedGame.Seat told = outcome.seats().get(seat);
            seats.add(new StoredSeat(lineup[seat], told.rank(), told.score(), told.fault(), told.answers(),
                told.meanNanos(), told.worstNanos(), told.firstNanos(),
                outcome.facts().values(seat)));
        }
        StoredGame own = new StoredGame(0, name, decision, game.seed(), game.attempt(), game.counts(),
            outcome.turns(), null, game.played(), game.machine(), null, outcome.facts().transcript(), seats);
        checkSame(place, game, own);
        return own;
    }

    /** Refuses a row that says something else than its transcript. */
    private static void checkSame(String place, StoredGame told, StoredGame own) {
        String said = told.turns() + " turns, ranks " + told.ranks();
        String is = own.turns() + " turns, ranks " + own.ranks();
        if (!said.equals(is)) {
            throw new InputException(place + ": found " + said + ", expected as in its transcript " + is);
        }
    }

    private static String place(String source, StoredGame game) {
        return source + ": game " + HexFormat.of().formatHex(game.name());
    }

    /** The game, its players named as there. */
    private static ExpectedGame expected(PartStore part, StoredGame game, Map<Integer, Version> versions) {
        Map<Integer, String> names = part.games().versions().stream()
            .collect(Collectors.toMap(Version::id, Version::display));
        List<Protocol> protocols = Arrays.stream(game.lineup()).mapToObj(versions::get).map(own -> Contest.entrant(
            new LeagueBot(own.bot(), own.command(), null, false, false).typed(), Protocol.JSON).protocol()).toList();
        return new ExpectedGame(game.seed(), Arrays.stream(game.lineup()).mapToObj(names::get).toList(), protocols);
    }

    /** Asks those bots again that do not draw by lot and are still the same. @return true if there is any */
    private boolean askAgain(PartStore part, String source, StoredGame game, Map<Integer, Version> versions) {
        boolean any = false;
        try {
            RecordedMatch match = transcripts.match(place(source, game), part.transcript(game.id()),
                expected(part, game, versions));
            for (int seat = 0; seat < game.seats().size(); seat++) {
                Optional<Entrant> entrant = deterministic(versions.get(game.lineup()[seat]));
                if (entrant.isPresent()) {
                    answers.check(match, seat, entrant.get());
                    any = true;
                }
            }
        } catch (DisprovedException wrong) {
            throw new InputException(wrong.getMessage());
        }
        return any;
    }

    private Optional<Entrant> deterministic(Version version) {
        return roster.members().stream().filter(member -> member.version().id() == version.id()
            && member.playsHere() && !member.bot().random() && !version.random()).map(Member::entrant).findFirst();
    }

    /** Returns the game with its replay, if the league keeps it. */
    private StoredGame kept(PartStore part, String source, Checked checked, Map<Integer, Version> versions) {
        StoredGame game = checked.own;
        byte[] transcript = part.transcript(checked.told.id());
        Map<Integer, String> bots = versions.values().stream().distinct()
            .collect(Collectors.toMap(Version::id, Version::bot));
        List<String> names = Arrays.stream(game.lineup()).mapToObj(bots::get).toList();
        if (transcript == null || !KeptGames.keeps(roster.settings(), game.problem() == null, game.seats(), names)) {
            return game;
        }
        try {
            String file = keeper.take(game.name(), transcripts.replay(place(source, game), transcript,
                expected(part, checked.told, versions)), true);
            return new StoredGame(0, game.name(), game.decision(), game.seed(), game.attempt(), game.counts(),
                game.turns(), game.problem(), game.played(), game.machine(), file, game.transcript(), game.seats());
        } catch (DisprovedException wrong) {
            throw new InputException(wrong.getMessage());
        }
    }
}
