package steward.cli.shared;

import java.util.List;
import picocli.CommandLine;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;
import steward.bot.TimeBasis;
import steward.bot.hold.HoldPolicy;
import steward.bot.isolation.SandboxLevel;
import steward.contest.Hiccups;
import steward.contest.KeptReplays;
import steward.game.podrace.RulesEdition;
import steward.league.sequential.Gsprt;
import steward.match.Protocol;
import steward.text.EnumWords;
import steward.text.NearestName;

/**
 * Converter of options whose values are fixed words.
 *
 * @param choices the values that a call may have
 */
public record WordConverter<E extends Enum<E>>(List<E> choices) implements ITypeConverter<E> {

    @Override
    public E convert(String word) {
        return EnumWords.find(choices, word).orElseThrow(() -> new TypeConversionException("found '" + word
            + "', expected " + EnumWords.listed(choices) + NearestName.question(word, EnumWords.of(choices), "'")));
    }

    /** Registers these for all options of a program; to be called after its commands are added. */
    public static void register(CommandLine program) {
        register(program, Protocol.class, Protocol.values());
        register(program, TimeBasis.class, TimeBasis.CHOICES.toArray(TimeBasis[]::new));
        register(program, HoldPolicy.class, HoldPolicy.values());
        register(program, SandboxLevel.class, SandboxLevel.values());
        register(program, Hiccups.class, Hiccups.values());
        register(program, KeptReplays.class, KeptReplays.values());
        register(program, RulesEdition.class, RulesEdition.values());
        register(program, Gsprt.Model.class, Gsprt.Model.values());
    }

    private static <E extends Enum<E>> void register(CommandLine program, Class<E> type, E[] choices) {
        program.registerConverter(type, new WordConverter<>(List.of(choices)));
    }
}
