package steward.scene.json;

import tools.jackson.core.TokenStreamLocation;

/** A place in a text; lines and columns count from 1. */
public record Place(int line, int column) {

    static Place of(TokenStreamLocation location) {
        return new Place(Math.max(1, location.getLineNr()), Math.max(1, location.getColumnNr()));
    }
}
