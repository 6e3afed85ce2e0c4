package steward.cli.shared;

import java.util.List;
import steward.files.InputException;
import steward.text.TextFormat;

/** Player of a recorded match that an option names: by a number, counted from 0, or by name. */
public final class PlayerChoice {

    /** Characters of the list of names that are shown: they come from a file. */
    private static final int LONGEST_LIST = 500;

    private PlayerChoice() { }

    /**
     * The player's number.
     *
     * @param typed  by a person
     * @param source name of the replay, for errors
     * @throws InputException if there is no such player; says which there are
     */
    public static int of(String typed, List<String> names, String source) {
        return of("--player", typed, names, source);
    }

    /** Returns the player's number as above. @param option that means it */
    public static int of(String option, String typed, List<String> names, String source) {
        int named = names.indexOf(typed);
        boolean number = typed.matches("[0-9]{1,3}") && Integer.parseInt(typed) < names.size();
        if (!number && named < 0) {
            String found = typed.matches("-?[0-9]+") ? typed : "'" + typed + "'";
            throw new InputException(option + ": found " + found + ", expected 0 to " + (names.size() - 1) + " in "
                + source + ", or a name: " + TextFormat.shorten(String.join(", ", names), LONGEST_LIST));
        }
        return number ? Integer.parseInt(typed) : named;
    }
}
