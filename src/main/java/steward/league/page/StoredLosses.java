package steward.league.page;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import steward.contest.Failure;
import steward.contest.Losers;
import steward.contest.loss.LeadLog;
import steward.contest.loss.Losses;
import steward.contest.repeat.Repeats;
import steward.files.InputException;
import steward.game.GameTypes;
import steward.league.StoredGame;
import steward.league.StoredGame.StoredSeat;
import steward.league.rating.Results;
import steward.replay.JsonLine;
import steward.replay.RecordedTurn;
import steward.replay.ReplayException;
import steward.replay.ReplayReader;
import steward.replay.verify.Resimulation;
import steward.scene.json.SceneException;

/**
 * Converter of a league's stored games to {@link steward.contest.loss.Losses}, the account of the games that one bot
 * lost. How a game ended and who led when is found by playing its replay again. Without a replay only failures are
 * known.
 */
public final class StoredLosses {

    private static final String DATA = "data";

    private final int version;
    private final boolean lower;
    private final Path folder;
    private final GameTypes types;
    private final Set<Integer> random;
    private final Repeats seen = new Repeats();
    private final List<StoredGame> lost = new ArrayList<>();
    private final List<StoredGame> won = new ArrayList<>();
    private final Losses losses;

    /**
     * What a replay says.
     *
     * @param behindFrom by player, or empty
     * @param out        by player why it was out, or {@code null}
     * @param data       by player what it and all reported
     */
    private record Told(String ending, List<Integer> behindFrom, String[] out, List<Map<String, Double>> data) { }

    private static final Told NOTHING = new Told(null, List.of(), new String[0], List.of());

    /**
     * None yet of a bot.
     *
     * @param bot    its name
     * @param random versions that draw by lot: equal games of theirs are no repeats
     * @param lower  whether a lower score is better
     * @param folder of the replays
     * @param types  games with which they are played again
     */
    public StoredLosses(String bot, int version, Set<Integer> random, boolean lower, Path folder, GameTypes types) {
        this.version = version;
        this.random = Set.copyOf(random);
        this.lower = lower;
        this.folder = folder;
        this.types = types;
        losses = new Losses(bot, lower);
    }

    /** Takes a game of the bot, the latest first; one that is not rated tells nothing. */
    public void add(StoredGame game) {
        if (!game.isRated() || game.seats().size() < 2) {
            return;
        }
        int seat = seat(game);
        if (seat < 0) {
            return;
        }
        int[] lineup = game.lineup();
        if (Arrays.stream(lineup).noneMatch(random::contains)
            && seen.isRepeat(Results.lineup(lineup), game.transcript())) {
            losses.repeat();
            return;
        }
        switch (outcome(game, seat)) {
            case LOST -> lost.add(game);
            case WON -> won.add(game);
            default -> add(game, seat, NOTHING);
        }
    }

    private static Losses.Outcome outcome(StoredGame game, int seat) {
        return Losses.Outcome.of(game.seats().get(seat).rank(),
            game.seats().stream().filter(each -> each.rank() == 0).count());
    }

    private int seat(StoredGame game) {
        for (int seat = 0; seat < game.seats().size(); seat++) {
            if (game.seats().get(seat).version() == version) {
                return seat;
            }
        }
        return -1;
    }

    /** Returns the account. @param most replays that are read at most of lost games, and of others: the latest ones */
    public Losses read(int most) {
        read(lost, true, most);
        read(won, false, most);
        return losses;
    }

    private void read(List<StoredGame> games, boolean isLost, int most) {
        int read = 0;
        for (StoredGame game : games) {
            int seat = seat(game);
            Told told = read < most ? told(game, isLost) : NOTHING;
            if (told != NOTHING) {
                read++;
            } else if (!isLost || game.seats().get(seat).fault() == null) {
                losses.skip(isLost);
            }
            add(game, seat, told);
        }
        games.clear();
    }

    private void add(StoredGame game, int seat, Told told) {
        StoredSeat own = game.seats().get(seat);
        Comparator<Double> better = lower ? Comparator.reverseOrder() : Comparator.naturalOrder();
        double winner = game.seats().stream().filter(other -> other != own && other.rank() == 0)
            .map(StoredSeat::score).max(better)
            .orElse(own.score());
        Map<String, Double> values = new TreeMap<>(own.values());
        if (seat < told.data().size()) {
            told.data().get(seat).forEach(values::putIfAbsent);
        }
        String out = seat < told.out().length ? told.out()[seat] : null;
        losses.add(new Losses.Game("game " + game.id() + " (seed " + game.seed() + ")", outcome(game, seat),
            Losses.kind(own.fault() == null ? null : Failure.kind(own.fault()), out == null ? null : Failure.kind(out),
                told.ending()), game.turns(), seat < told.behindFrom().size() ? told.behindFrom().get(seat)
                : LeadLog.UNKNOWN, own.score(), winner, values,
            game.replay() == null ? null : folder.resolve(game.replay()).toString()));
    }

    private Told told(StoredGame game, boolean isLost) {
        Path replay = game.replay() == null ? null : folder.resolve(game.replay());
        if (replay == null || !Files.isRegularFile(replay)) {
            return NOTHING;
        }
        try (ReplayReader reader = ReplayReader.open(replay)) {
            return reader.header() == null ? NOTHING : isLost ? told(reader) : reported(reader);
        } catch (IOException | ReplayException | SceneException | InputException damaged) {
            return NOTHING;                            // 'league verify' says what is wrong with it
        }
    }

    /** Data of a game that need not be played again. */
    private static Told reported(ReplayReader reader) throws IOException {
        boolean more = true;
        while (more) {
            more = reader.next() != null;
        }
        return new Told(reader.ending(), List.of(), new String[0], data(reader.result()));
    }

    private Told told(ReplayReader reader) {
        Resimulation again = new Resimulation(reader.header(), reader.start(), types, reader.source());
        LeadLog leads = again.setup().isGuest() ? null : new LeadLog(again.game().players());
        boolean played = leads != null;
        for (RecordedTurn turn = reader.next(); turn != null; turn = reader.next()) {
            played = played && again.play(turn) == null;
            if (played) {
                leads.note(again.game());
            }
        }
        String[] out = new String[again.game().players()];
        for (int player = 0; played && player < out.length; player++) {
            out[player] = again.game().eliminationReason(player);
        }
        return new Told(reader.ending(), played ? leads.behindFrom() : List.of(), out, data(reader.result()));
    }

    /** By player what it reported, and what was reported of the match. */
    private static List<Map<String, Double>> data(JsonLine result) {
        List<Map<String, Double>> all = new ArrayList<>();
        for (JsonLine player : result == null ? List.<JsonLine>of() : result.objects("players")) {
            Map<String, Double> values = new TreeMap<>();
            Losers.addNumbers(values, data("data of a player", player));
            Losers.addNumbers(values, data("data of the match", result));
            all.add(values);
        }
        return all;
    }

    private static Map<String, String> data(String where, JsonLine line) {
        Map<String, String> data = new TreeMap<>();
        if (line.has(DATA)) {
            JsonLine object = new JsonLine(where, line.object(DATA));
            object.names().forEach(name -> data.put(name, object.text(name)));
        }
        return data;
    }
}
