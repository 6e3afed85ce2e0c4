package steward.guest.project;

import java.nio.file.Path;

/**
 * League level that has the full rules of a contest, and the reason. It is the highest level that has a folder, or the
 * next one if class files compare the level with a greater number. Without folders it is the lowest level above which
 * class files distinguish no levels.
 *
 * @param level       chosen
 * @param reason      for people, without a full stop
 * @param mayHaveMore whether nothing but games can show that the next level has other rules
 */
public record LeagueLevels(int level, String reason, boolean mayHaveMore) {

    /** Chooses by folders and class files. */
    public static LeagueLevels of(SdkProject project) {
        LevelComparisons compared = LevelComparisons.of(Path.of(project.classPath().get(0)));
        int folders = project.levels();
        if (folders == 0) {
            return compared.lastChange() == 1 ? new LeagueLevels(1, "since the project has no levels", false)
                : new LeagueLevels(compared.lastChange(), "since there are no folders of levels, and the class files "
                    + "tell levels apart up to this one", false);
        }
        return compared.singledOut() > folders
            ? new LeagueLevels(folders + 1, "since the folders end with level" + folders + ", and the class files "
                + "compare the level with a number that reaches past it", false)
            : new LeagueLevels(folders, "the highest that has a folder; no class file compares the level with a number "
                + "that reaches past it", true);
    }

    /** Returns the next level, for games that differ. */
    public LeagueLevels more() {
        return new LeagueLevels(level + 1, "since the folders end with level" + level + ", and games between the "
            + "contest's own bots differ beyond it", false);
    }

    /** Returns the level below, since no game at this one comes to its end. */
    public LeagueLevels withoutLast() {
        return new LeagueLevels(level - 1, "since games at level " + level + " fail", false);
    }
}
