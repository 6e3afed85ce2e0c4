package steward.codingame.recording;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;

/** A game of each kind in the form of the site's JSON; that of the Poker Chip Race is a real one's beginning. */
public final class SiteGames {

    private SiteGames() {
    }

    /** The text of a game by the name of its kind; one without any here fails. */
    public static String of(String game) throws IOException {
        return switch (game) {
            case "pod-race" -> OfficialGame.play(12).json();
            case "search-race" -> ServerGame.searchRace().toString();
            case "mean-max" -> ServerMeanMax.play(5, 33).json();
            case "fantastic-bits" -> ServerGame.fantasticBits().toString();
            case "poker-chip-race" -> excerpt();
            default -> throw new AssertionError("no recorded game of " + game + " is known here");
        };
    }

    private static String excerpt() throws IOException {
        try (InputStream in = SiteGames.class.getResourceAsStream("/pokerchiprace/server-frames0-8.json")) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        }
    }
}
