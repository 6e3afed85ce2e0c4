package steward.game;

import steward.scene.SceneFiles;
import steward.text.ViewLines;

/** Views of a game whose shipped scene and seed say how it begins. */
record SeededView(String title, String scene) implements ServerView {

    @Override
    public Start open(ViewLines first, String input) {
        return new Start(SceneFiles.load(scene).text(), ShownSeed.required(input, first.source()));
    }
}
