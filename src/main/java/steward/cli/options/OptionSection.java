package steward.cli.options;

import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/** Annotation with the heading in a command's help under which an option, or all options of a class, are listed. */
@Retention(RetentionPolicy.RUNTIME)
@Target({ElementType.TYPE, ElementType.FIELD})
public @interface OptionSection {

    /** The heading, without a colon. */
    String value();

    /** The command of {@code steward help} that tells of all but the first of them, or nothing. */
    String help() default "";
}
