package steward.cli;

import java.lang.reflect.Field;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
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

    /** Gives the usual options their short names, in the order in which they are. */
    static void shorten(CommandSpec spec) {
        List<OptionSpec> all = List.copyOf(spec.options());
        all.forEach(spec::remove);
        for (OptionSpec option : all) {
            String full = option.longestName();
            String name = SHORT.get(full);
            spec.addOption(name == null ? option : OptionSpec.builder(option).names(name, full).build());
        }
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
            boolean elsewhere = !section.elsewhere().isEmpty() && options.size() > 1;
            text.append('\n').append(section.value()).append(elsewhere
                ? "; " + (options.size() - 1) + " more options: steward help " + section.elsewhere() : "").append(":\n")
                .append(help.optionListExcludingGroups(elsewhere ? options.subList(0, 1) : options));
        });
        return text.toString();
    }

    private static OptionSection section(Field field) {
        OptionSection own = field.getAnnotation(OptionSection.class);
        return own != null ? own : field.getDeclaringClass().getAnnotation(OptionSection.class);
    }
}
