package steward.cli.sequential;

import steward.json.JsonObject;
import steward.league.tune.Parameter;
import steward.league.tune.Spsa;
import steward.league.tune.TunedCommand;
import tools.jackson.core.JsonGenerator;

/** Result of a search for parameters, as fields of one JSON object; values are as in the command. */
final class TuneJson {

    /**
     * @param tied  steps in which both sets of values scored alike
     * @param found whether there were steps enough for a result; without it {@code bot} is null
     */
    static void write(JsonGenerator out, TunedCommand command, Spsa search, int tied, boolean found) {
        out.writeNumberProperty("steps", search.step());
        out.writeNumberProperty("tied", tied);
        out.writeStringProperty("bot", found ? command.with(search.result()) : null);
        JsonObject.writeAll(out, "parameters", command.parameters().size(), k -> {
            Parameter parameter = command.parameters().get(k);
            out.writeStringProperty("name", parameter.name());
            out.writeStringProperty("start", parameter.value(command.start()[k]));
            if (found) {
                double value = search.result()[k];
                double most = 2 * search.spread()[k];
                out.writeStringProperty("result", parameter.value(value));
                out.writeStringProperty("low", parameter.value(value - most));
                out.writeStringProperty("high", parameter.value(value + most));
            }
        });
    }
}
