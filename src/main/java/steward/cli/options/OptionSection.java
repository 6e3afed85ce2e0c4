package steward.cli.options;

import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/** Heading of an option, or of all options of a class, in the help of a command. */
@Retention(RetentionPolicy.RUNTIME)
@Target({ElementType.TYPE, ElementType.FIELD})
public @interface OptionSection {

    /** The heading, without a colon. */
    String value();

    /** The command of {@code steward help} that tells of all but the first of them, or nothing. */
    String elsewhere() default "";
}
