package steward.cli.shared;

import picocli.CommandLine;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

/** Reads the numbers of a call; the library's own readers tell people about {@code int} and {@code long}. */
public enum NumberConverter implements ITypeConverter<Number> {

    /** 32 bits. */
    INTEGER("a whole number below 2^31"),
    /** 64 bits. */
    LONG("a whole number of 64 bits"),
    /** Any. */
    DOUBLE("a number");

    private final String expected;

    NumberConverter(String expected) {
        this.expected = expected;
    }

    @Override
    public Number convert(String word) {
        try {
            return switch (this) {
                case INTEGER -> (Number) Integer.valueOf(word);
                case LONG -> (Number) Long.valueOf(word);
                default -> (Number) Double.valueOf(word);
            };
        } catch (NumberFormatException problem) {
            throw new TypeConversionException("found '" + word + "', expected " + expected);
        }
    }

    /** Uses these for all options of a program; call when its commands are there. */
    public static void register(CommandLine program) {
        register(program, Integer.class, INTEGER);
        register(program, Long.class, LONG);
        register(program, long.class, LONG);
        register(program, Double.class, DOUBLE);
    }

    /** What is read for a type is of that type, or of its box. */
    @SuppressWarnings("unchecked")
    private static <K> void register(CommandLine program, Class<K> type, NumberConverter reader) {
        program.registerConverter(type, (ITypeConverter<K>) (ITypeConverter<?>) reader);
    }
}
