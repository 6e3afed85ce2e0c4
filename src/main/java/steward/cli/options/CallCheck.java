package steward.cli.options;

import java.util.List;
import java.util.function.Function;
import steward.cli.shared.CallException;
import steward.files.InputException;
import steward.text.NearestName;

/** Check that refuses calls whose options are out of range or exclude each other. */
public final class CallCheck {

    public static final int MOST_THREADS = 256;
    public static final int MOST_GAMES = 1_000_000;

    private final boolean help;

    private CallCheck(boolean help) {
        this.help = help;
    }

    /** Its refusals end with how to get the command's help. */
    public static CallCheck withHelp() {
        return new CallCheck(true);
    }

    /** Its refusals are the problem and no more. */
    public static CallCheck brief() {
        return new CallCheck(false);
    }

    /** Refuses the call unless the condition holds. */
    public void that(boolean right, String problem) {
        if (!right) {
            throw help ? new CallException(problem) : new InputException(problem);
        }
    }

    /** Refuses two options that are both there. */
    public void exclusive(String one, boolean hasOne, String other, boolean hasOther) {
        that(!hasOne || !hasOther, one + " and " + other + " exclude each other");
    }

    /** @param found {@code null} where the option is not there */
    public void range(String option, Number found, long least, long most) {
        that(found == null || isWithin(found.longValue(), least, most), outside(option, found, least, most));
    }

    /** True if a number is in a range, both ends included. */
    public static boolean isWithin(long found, long least, long most) {
        return found >= least && found <= most;
    }

    /** Returns the error of an option whose number is out of range. */
    public static String outside(String option, Number found, long least, long most) {
        return option + ": found " + found + ", expected " + least + " to " + most;
    }

    /** @param games as {@code --games} says, or {@code null} */
    public void games(Integer games) {
        range("--games", games, 1, MOST_GAMES);
    }

    /**
     * Returns the values that a repeatable option chooses by name.
     *
     * @param names as they were given; all are chosen where there are none
     */
    public <T> List<T> chosen(String option, List<String> names, List<T> all, Function<T, String> nameOf) {
        List<String> known = all.stream().map(nameOf).toList();
        for (String name : names) {
            that(known.contains(name), option + ": found '" + name + "', expected one of "
                + String.join(", ", known) + NearestName.question(name, known, "'"));
        }
        return names.isEmpty() ? all : all.stream().filter(each -> names.contains(nameOf.apply(each))).toList();
    }
}
