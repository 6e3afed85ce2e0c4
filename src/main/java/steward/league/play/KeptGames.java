package steward.league.play;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.HexFormat;
import java.util.List;
import steward.contest.Contest;
import steward.contest.KeptReplays;
import steward.files.InputException;
import steward.files.OutputFiles;
import steward.league.LeagueFolder;
import steward.league.LeagueSettings;
import steward.league.StoredGame;
import steward.league.StoredGame.StoredSeat;
import steward.match.MatchListener;
import steward.match.MatchResult;

/**
 * Replays that a league's settings keep, stored in the league's folder.
 *
 * @param folder the league's
 */
public record KeptGames(LeagueFolder folder) implements GamePlay.Recordings {

    @Override
    public GamePlay.Recorder recorder(LeagueSettings settings) {
        ByteArrayOutputStream replay = settings.keep() == KeptReplays.NONE ? null : new ByteArrayOutputStream();
        return new GamePlay.Recorder() {
            @Override
            public MatchResult play(Contest match, long seed, MatchListener log) throws InterruptedException {
                return match.play(seed, 0, replay, log);
            }

            @Override
            public byte[] recording() {
                return replay == null || replay.size() == 0 ? null : replay.toByteArray();
            }
        };
    }

    @Override
    public String take(byte[] game, byte[] replay, boolean kept) {
        try {
            return kept ? write(folder, game, replay) : null;
        } catch (IOException failed) {
            throw new InputException(folder.replays() + ": a replay cannot be written: "
                + OutputFiles.reason(folder.replays(), failed));
        }
    }

    /**
     * True if the replay of a game that is over is kept.
     *
     * @param names of the bots, by seat
     */
    public static boolean keeps(LeagueSettings settings, boolean result, List<StoredSeat> seats, List<String> names) {
        return switch (settings.keep()) {
            case ALL -> true;
            case FAILED -> !result || seats.stream().anyMatch(seat -> seat.fault() != null);
            case LOST -> result && isLost(settings, seats, names);
            case NONE -> false;
        };
    }

    private static boolean isLost(LeagueSettings settings, List<StoredSeat> seats, List<String> names) {
        for (int seat = 0; seat < seats.size(); seat++) {
            boolean meant = settings.keepOf().isEmpty() || settings.keepOf().contains(names.get(seat));
            if (meant && seats.get(seat).rank() > 0) {
                return true;
            }
        }
        return false;
    }

    /**
     * Writes a replay as a whole: what has the name of a replay is never a part of one.
     *
     * @return its path in the folder of replays
     * @throws IOException if it cannot be written
     */
    static String write(LeagueFolder folder, byte[] name, byte[] replay) throws IOException {
        String digits = HexFormat.of().formatHex(name);
        String place = digits.substring(0, 2) + "/" + digits + ".jsonl";
        Path file = folder.replays().resolve(place);
        Path part = file.resolveSibling(digits + ".part");
        try {
            Files.createDirectories(file.getParent());
            Files.write(part, replay);
            Files.move(part, file, StandardCopyOption.ATOMIC_MOVE);
        } catch (IOException problem) {
            remove(part);
            throw problem;
        }
        return place;
    }

    private static void remove(Path part) {
        try {
            Files.deleteIfExists(part);
        } catch (IOException stays) {
            return;
        }
    }

    /** Removes the replay of a game that is not stored after all. */
    public static void remove(LeagueFolder folder, StoredGame game) {
        if (game.replay() != null) {
            remove(folder.replays().resolve(game.replay()));
        }
    }
}
