package steward.league.play;

import java.io.IOException;
import java.io.UncheckedIOException;
import steward.contest.GameFacts;
import steward.game.GameTypes;
import steward.league.LeagueFolder;
import steward.league.store.GameStore;
import steward.replay.ReplayException;
import steward.replay.ReplayReader;
import steward.scene.json.SceneException;

/** Transcripts and own values of games that an earlier version stored, from the replays that were kept. */
public final class EarlierFacts {

    private EarlierFacts() { }

    /** Adds what is missing. A game whose replay is missing or cannot be played again stays without. */
    public static void add(LeagueFolder folder, GameStore store, GameTypes types) {
        for (GameStore.Unknown game : store.unknown()) {
            try (ReplayReader replay = ReplayReader.open(folder.replays().resolve(game.replay()))) {
                store.add(game.id(), GameFacts.of(replay, types));
            } catch (IOException | UncheckedIOException | ReplayException | SceneException unreadable) {
                continue;
            }
        }
    }
}
