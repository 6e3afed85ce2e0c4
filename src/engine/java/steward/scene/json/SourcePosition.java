package steward.scene.json;

import tools.jackson.core.TokenStreamLocation;

/** Position in a text; lines and columns count from 1. */
public record SourcePosition(int line, int column) {

    static SourcePosition of(TokenStreamLocation location) {
        return new SourcePosition(Math.max(1, location.getLineNr()), Math.max(1, location.getColumnNr()));
    }
}
