package steward.replay;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import tools.jackson.core.JsonParser;
import tools.jackson.core.JsonToken;
import tools.jackson.core.ObjectReadContext;
import tools.jackson.core.json.JsonFactory;

/** Where every scalar of a JSON line stands, for tests that edit one. */
public final class JsonLeaves {

    /**
     * A scalar value.
     *
     * @param path such as {@code /outcome/state/bodies/0/x}
     * @param from first byte
     * @param to   the byte behind the last
     */
    public record Leaf(String path, int from, int to) {
    }

    private JsonLeaves() {
    }

    public static List<Leaf> of(String line) {
        byte[] bytes = line.getBytes(StandardCharsets.UTF_8);
        List<Leaf> leaves = new ArrayList<>();
        try (JsonParser in = new JsonFactory().createParser(ObjectReadContext.empty(), bytes, 0, bytes.length)) {
            for (JsonToken token = in.nextToken(); token != null; token = in.nextToken()) {
                if (token.isScalarValue()) {
                    int from = (int) in.currentTokenLocation().getByteOffset();
                    in.getString();
                    leaves.add(new Leaf(in.streamReadContext().pathAsPointer().toString(), from,
                        (int) in.currentLocation().getByteOffset()));
                }
            }
        }
        return leaves;
    }
}
