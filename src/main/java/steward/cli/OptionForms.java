package steward.cli;

import java.lang.reflect.Field;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Stream;
import picocli.CommandLine.Help;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Model.UsageMessageSpec;
import steward.cli.options.OptionSection;

/** Forms that the options of all commands share: short names of common options, and sections in the help. */
final class OptionForms {

    private static final Map<String, String> SHORT = Map.of("--bot", "-b", "--games", "-g", "--json", "-j", "--out",
        "-o", "--protocol", "-p", "--quiet", "-q", "--scene", "-s", "--threads", "-t", "--view", "-v", "--watch", "-w");
    /** Of more options the line of usage does not tell. */
    private static final int MOST_IN_SYNOPSIS = 12;

    /** Gives options, in their order, the words that complete them, and usual ones their short names if wanted. */
    static void complete(CommandSpec spec, boolean shorten) {
        List<OptionSpec> all = List.copyOf(spec.options());
        all.forEach(spec::remove);
        for (OptionSpec option : all) {
            String name = shorten ? SHORT.get(option.longestName()) : null;
            OptionSpec.Builder builder = OptionSpec.builder(option).completionCandidates(candidates(option));
            spec.addOption((name == null ? builder : builder.names(name, option.longestName())).build());
        }
    }

    /** Returns the words of a label such as {@code replay|count}, or of an enum, or those that the option declares. */
    private static Iterable<String> candidates(OptionSpec option) {
        List<String> words = Stream.of(option.paramLabel().split("\\|")).filter(word -> word.matches("[a-z]+"))
            .toList();
        return !words.isEmpty() ? words : option.type().isEnum()
            ? Stream.of(option.type().getEnumConstants()).map(each -> each.toString().toLowerCase(Locale.ROOT)).toList()
            : option.completionCandidates();
    }

    /** Puts options with an {@link OptionSection} below headings, after the others; of these the usual ones first. */
    static void arrange(CommandSpec spec) {
        UsageMessageSpec usage = spec.usageMessage();
        usage.abbreviateSynopsis(spec.options().size() > MOST_IN_SYNOPSIS);
        usage.sectionMap().put(UsageMessageSpec.SECTION_KEY_OPTION_LIST, OptionForms::list);
    }

    private static String list(Help help) {
        List<OptionSpec> plain = new ArrayList<>();
        Map<OptionSection, List<OptionSpec>> sections = new LinkedHashMap<>();
        for (OptionSpec option : help.commandSpec().options()) {
            OptionSection section = option.userObject() instanceof Field field ? section(field) : null;
            if (!option.hidden()) {
                (section == null ? plain : sections.computeIfAbsent(section, key -> new ArrayList<>())).add(option);
            }
        }
        plain.sort(Comparator.comparing(option -> !option.required() && !SHORT.containsKey(option.longestName())));
        StringBuilder text = new StringBuilder(help.optionListExcludingGroups(plain));
        sections.forEach((section, options) -> {
            boolean isInHelp = !section.help().isEmpty() && options.size() > 1;
            text.append('\n').append(section.value()).append(isInHelp
                ? "; " + (options.size() - 1) + " more options: steward help " + section.help() : "").append(":\n")
                .append(help.optionListExcludingGroups(isInHelp ? options.subList(0, 1) : options));
        });
        return text.toString();
    }

    private static OptionSection section(Field field) {
        OptionSection own = field.getAnnotation(OptionSection.class);
        return own != null ? own : field.getDeclaringClass().getAnnotation(OptionSection.class);
    }
}
