package steward.machines.wire;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import tools.jackson.databind.json.JsonMapper;

/** Builder of a message's header, a JSON object, field by field. */
public final class HeaderText {

    private final Map<String, Object> fields = new LinkedHashMap<>();

    /** A text, a number, a truth value, or a list of texts or objects; one that is {@code null} is left out. */
    public HeaderText put(String name, Object value) {
        if (value != null) {
            fields.put(name, value instanceof List<?> list
                ? list.stream().map(each -> each instanceof HeaderText object ? object.fields : each).toList() : value);
        }
        return this;
    }

    /** The object on one line. */
    public String text() {
        return JsonMapper.shared().writeValueAsString(fields);
    }
}
