package steward.league.tune;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/**
 * A bot's command that contains parameters to be tuned.
 *
 * @param parts      what stands between them; one more than parameters
 * @param parameters in their order
 */
public record TunedCommand(List<String> parts, List<Parameter> parameters) {

    public TunedCommand {
        parts = List.copyOf(parts);
        parameters = List.copyOf(parameters);
    }

    /**
     * Reads a command.
     *
     * @throws IllegalArgumentException if it has no parameter, one twice, or one that is none
     */
    public static TunedCommand parse(String text) {
        List<String> parts = new ArrayList<>();
        List<Parameter> parameters = new ArrayList<>();
        int from = 0;
        for (int open = text.indexOf('{'); open >= 0; open = text.indexOf('{', from)) {
            int close = text.indexOf('}', open);
            if (close < 0) {
                throw new IllegalArgumentException("found '" + text.substring(open) + "', expected a closing brace");
            }
            Parameter parameter = Parameter.parse(text.substring(open + 1, close));
            if (parameters.stream().anyMatch(other -> other.name().equals(parameter.name()))) {
                throw new IllegalArgumentException("found the parameter '" + parameter.name()
                    + "' twice, expected each once");
            }
            parts.add(text.substring(from, open));
            parameters.add(parameter);
            from = close + 1;
        }
        if (parameters.isEmpty()) {
            throw new IllegalArgumentException("found no parameter in '" + text
                + "', expected at least one, such as {look:1..9}");
        }
        parts.add(text.substring(from));
        return new TunedCommand(parts, parameters);
    }

    /** The command with the values at these places. */
    public String with(double... places) {
        StringBuilder text = new StringBuilder(parts.get(0));
        for (int k = 0; k < parameters.size(); k++) {
            text.append(parameters.get(k).value(places[k])).append(parts.get(k + 1));
        }
        return text.toString();
    }

    /** Names and values at these places, for people. */
    public String text(double... places) {
        return IntStream.range(0, parameters.size()).mapToObj(k -> parameters.get(k).name() + " "
            + parameters.get(k).value(places[k])).collect(Collectors.joining(", "));
    }

    public double[] start() {
        return parameters.stream().mapToDouble(Parameter::start).toArray();
    }
}
