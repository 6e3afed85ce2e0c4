package steward.cli.options;

import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/** The heading of a class's options in the help of a command. */
@Retention(RetentionPolicy.RUNTIME)
@Target(ElementType.TYPE)
public @interface OptionSection {

    /** The heading, without a colon. */
    String value();

    /** The command of {@code steward help} that tells of all but the first of them, or nothing. */
    String elsewhere() default "";
}
