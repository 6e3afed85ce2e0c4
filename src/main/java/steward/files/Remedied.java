package steward.files;

import java.util.List;

/** Interface of an exception that another option would prevent. Commands that have the option name it. */
public interface Remedied {

    /** The options; none if nothing would help. */
    List<Remedy> remedies();

    /**
     * An option.
     *
     * @param option its name, without dashes
     * @param effect its effect, such as {@code would replace it}
     */
    record Remedy(String option, String effect) { }
}
