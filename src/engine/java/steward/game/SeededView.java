package steward.game;

import steward.scene.SceneFiles;
import steward.text.ViewLines;

/** Reader of a recording's start for games whose start follows from a shipped scene and the seed. */
record SeededView(String title, String scene) implements ServerView {

    @Override
    public Start open(ViewLines first, String input) {
        return new Start(SceneFiles.load(scene).text(), ShownSeed.required(input, first.source()));
    }
}
