package steward.cli.shared;

import picocli.CommandLine;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

/**
 * Converter of numbers of a call, with readable errors: the library's own converters name {@code int} and {@code long}.
 */
public enum NumberConverter implements ITypeConverter<Number> {

    /** 32 bits. */
    INTEGER("a whole number below 2^31"),
    /** 64 bits. */
    LONG("a whole number of 64 bits"),
    /** Any number. */
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

    /** Registers these for all options of a program; to be called after its commands are added. */
    public static void register(CommandLine program) {
        register(program, Integer.class, INTEGER);
        register(program, Long.class, LONG);
        register(program, long.class, LONG);
        register(program, Double.class, DOUBLE);
    }

    /** The converted value has the option's type, or its box type. */
    @SuppressWarnings("unchecked")
    private static <K> void register(CommandLine program, Class<K> type, NumberConverter reader) {
        program.registerConverter(type, (ITypeConverter<K>) (ITypeConverter<?>) reader);
    }
}
