package steward.cli.sequential;

import steward.league.tune.Parameter;
import steward.league.tune.Spsa;
import steward.league.tune.TunedCommand;
import steward.report.Fields;

/** Result of a search for parameters, as fields of one JSON object; values are as in the command. */
final class TuneJson {

    /**
     * @param tied  steps in which both sets of values scored alike
     * @param found whether there were steps enough for a result; without it {@code bot} is null
     */
    static Fields of(TunedCommand command, Spsa search, int tied, boolean found) {
        return Fields.of("steps", search.step(), "tied", tied, "bot", found ? command.with(search.result()) : null,
            "parameters", Fields.each(command.parameters().size(), k -> {
                Parameter parameter = command.parameters().get(k);
                Fields fields = Fields.of("name", parameter.name(), "start", parameter.value(command.start()[k]));
                if (found) {
                    double value = search.result()[k];
                    double most = 2 * search.spread()[k];
                    fields.with("result", parameter.value(value), "low", parameter.value(value - most),
                        "high", parameter.value(value + most));
                }
                return fields;
            }));
    }
}
