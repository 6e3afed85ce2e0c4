package steward;

import java.lang.annotation.Documented;
import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/**
 * Mark of a method that is public only for other packages of the program, in a type that users may build on. The method
 * may change or go with any version. The types for users are listed in {@code docs/api.md}; no other type has marks.
 */
@Documented
@Retention(RetentionPolicy.CLASS)
@Target({ElementType.METHOD, ElementType.CONSTRUCTOR})
public @interface Internal {
}
