package steward.guest;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import steward.game.Game;
import steward.game.ViewWriter;
import steward.guest.RefereeBlock.Name;

/**
 * Writer of the frames of a guest's game, as the site's server records them. Each is what the referee says up to a
 * question or the end. A turn of ours has several if the referee asks for no lines, or asks a player who has failed.
 */
final class GuestViews implements ViewWriter {

    private GuestGame game;
    private List<List<RefereeBlock>> frames = List.of();

    /** Lines of a text as they are compared: without blanks at its end. */
    private static List<String> split(List<String> lines) {
        String text = String.join("\n", lines);
        return text.isBlank() ? List.of() : List.of(text.stripTrailing().split("\r?\n", -1));
    }

    @Override
    public List<String> notCompared() {
        List<String> not = new ArrayList<>(List.of("gameInformation, and what referee and players wrote to stderr"));
        Set<Name> differing = EnumSet.noneOf(Name.class);
        differing.addAll(game.undetermined());
        if (!differing.isEmpty()) {
            not.add(differing.stream().map(Name::name).collect(Collectors.joining(", "))
                + ", which the scene calls undetermined");
        }
        if (game.isMonitored()) {
            not.add("times of answers, which the referee asks for: it is told those that views show, elsewhere 0 ms");
        }
        return not;
    }

    @Override
    public boolean isVerbatim() {
        return true;
    }

    @Override
    public void begin(Game played) {
        game = (GuestGame) played;
        frames = List.of();
    }

    @Override
    public void before() {
        frames = List.of();
    }

    @Override
    public int frames() {
        if (frames.isEmpty()) {
            frames = new ArrayList<>();
            List<RefereeBlock> frame = new ArrayList<>();
            for (RefereeBlock block : game.blocks()) {
                frame.add(block);
                if (block.name().isLast()) {
                    frames.add(frame);
                    frame = new ArrayList<>();
                }
            }
        }
        return frames.size();
    }

    @Override
    public Frame start() {
        return answer(frames() - 1);
    }

    @Override
    public Frame after(String[] messages, List<String> shown) {
        return answer(frames() - 1);
    }

    @Override
    public Frame answer(int answer) {
        if (answer >= frames()) {
            return new Frame(List.of(), List.of(), null, List.of());
        }
        List<RefereeBlock> said = frames.get(answer);
        List<String> summary = lines(said, Name.SUMMARY);
        List<String> pairs = lines(said, Name.TOOLTIP);
        List<String> tooltips = pairs == null ? null : new ArrayList<>();
        for (int k = 0; pairs != null && k + 1 < pairs.size(); k += 2) {
            tooltips.add(pairs.get(k + 1) + " " + pairs.get(k));
        }
        // The summary of a game for one comes as a second block of this name.
        return new Frame(lines(said, Name.VIEW), summary != null && summary.isEmpty() ? lines(said, Name.INFOS)
            : summary, null, tooltips == null ? null : split(tooltips));
    }

    /** Lines of the last block of a name; none without it, {@code null} if it is not kept. */
    private List<String> lines(List<RefereeBlock> said, Name name) {
        return game.undetermined().contains(name) ? null : split(said.stream().filter(block -> block.name() == name)
            .reduce((before, last) -> last).map(RefereeBlock::lines).orElse(List.of()));
    }

    private List<String> atEnd(Name name) {
        return frames() == 0 ? List.of() : lines(frames.get(frames() - 1), name);
    }

    /** None behind the end. */
    @Override
    public List<String> declared() {
        return List.of();
    }

    @Override
    public double[] scores() {
        return game.toldScores();
    }

    /** In a fixed order: a referee says it in that of a hash. */
    @Override
    public List<String> input() {
        List<String> lines = atEnd(Name.UINPUT);
        return lines == null || lines.isEmpty() ? null : lines.stream().sorted().toList();
    }

    @Override
    public List<String> metadata() {
        return atEnd(Name.METADATA);
    }
}
