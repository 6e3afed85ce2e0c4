package steward;

import java.lang.annotation.Documented;
import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/**
 * Mark of a method that is public only because another room of the program uses it, in a type that users may build on:
 * it may change or go with any version. The types for users are listed in {@code docs/api.md}; no other carries a mark.
 */
@Documented
@Retention(RetentionPolicy.CLASS)
@Target({ElementType.METHOD, ElementType.CONSTRUCTOR})
public @interface Internal {
}
