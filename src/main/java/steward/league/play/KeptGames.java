package steward.league.play;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.HexFormat;
import steward.contest.KeptReplays;
import steward.league.LeagueFolder;
import steward.league.LeagueSettings;
import steward.league.StoredGame;
import steward.match.MatchResult;

/** The replays that a league keeps: which, and where. */
final class KeptGames {

    private KeptGames() {
    }

    /** Whether anything has to be recorded. */
    static boolean isAny(LeagueSettings settings) {
        return settings.keep() != KeptReplays.NONE;
    }

    /**
     * Whether the replay of a game that is over is kept.
     *
     * @param result or {@code null}
     * @param names  of the bots, by seat
     */
    static boolean keeps(LeagueSettings settings, MatchResult result, String... names) {
        return switch (settings.keep()) {
            case ALL -> true;
            case FAILED -> result == null || result.anyFault();
            case LOST -> result != null && isLost(settings, result, names);
            case NONE -> false;
        };
    }

    private static boolean isLost(LeagueSettings settings, MatchResult result, String... names) {
        for (int seat = 0; seat < names.length; seat++) {
            boolean meant = settings.keepOf().isEmpty() || settings.keepOf().contains(names[seat]);
            if (meant && result.players().get(seat).rank() > 0) {
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
            Files.move(part, file, StandardCopyOption.REPLACE_EXISTING);
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
    static void remove(LeagueFolder folder, StoredGame game) {
        if (game.replay() != null) {
            remove(folder.replays().resolve(game.replay()));
        }
    }
}
