package steward.league.store;

import java.nio.file.Files;
import java.util.Optional;
import java.util.regex.Pattern;
import steward.files.InputException;
import steward.league.FolderLock;
import steward.league.LeagueFolder;
import steward.league.LeagueSettings;
import steward.league.Season;
import steward.scene.SceneFiles;
import steward.scene.SceneKey;
import steward.scene.SceneReader;
import steward.scene.SceneText;

/** Shipped scenes as they were before their rules became those of the live server: without the word of the rules. */
public final class RulesBefore {

    private static final Pattern LIVE = Pattern.compile("\\n *\"rules\": \"live\",");

    private RulesBefore() { }

    /** The text of the scene before, if the league names a shipped one and its last season was played by that. */
    static Optional<String> scene(LeagueFolder folder, LeagueSettings settings, Season last) {
        String named = folder.scene(settings.scene());
        if (!SceneFiles.shipped().contains(named)) {
            return Optional.empty();
        }
        SceneText now = SceneFiles.load(named);
        String before = LIVE.matcher(now.text()).replaceFirst("");
        return Optional.of(before).filter(text -> !text.equals(now.text()) && SceneKey.of(
            SceneReader.read(new SceneText(text, now.source()), null)).equals(last.sceneKey()));
    }

    /**
     * Writes the scene before into the folder and names it in the settings, so that the league goes on by its old
     * rules. Does nothing if the last season was played by no such scene.
     *
     * @return whether it was written
     * @throws InputException if the folder has a scene of its own that would be lost
     */
    @SuppressWarnings("try")                           // the lock is only closed, never used
    public static boolean keep(LeagueFolder folder) {
        if (!Files.exists(folder.database())) {
            return false;
        }
        try (FolderLock lock = FolderLock.take(folder)) {
            LeagueSettings settings = folder.read();
            Optional<Season> last;
            try (GameStore store = GameStore.write(folder)) {    // a form of before is brought up to date
                last = store.lastSeason();
            }
            Optional<String> before = last.flatMap(season -> scene(folder, settings, season));
            before.ifPresent(text -> folder.write(text, settings));
            return before.isPresent();
        }
    }
}
