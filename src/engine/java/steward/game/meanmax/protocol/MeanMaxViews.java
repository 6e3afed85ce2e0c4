package steward.game.meanmax.protocol;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.IntStream;
import steward.game.Game;
import steward.game.ShownMessages;
import steward.game.ViewWriter;
import steward.game.meanmax.MeanMax;
import steward.game.meanmax.MeanMaxWorld;
import steward.game.meanmax.Sinking;
import steward.game.meanmax.SkillEffect;
import steward.game.meanmax.UnitKind;
import steward.game.meanmax.Wreck;
import steward.physics.Bodies;
import steward.physics.TeeSink;
import steward.scene.Scene;

/**
 * Writer of views of Mean Max as the server shows them:
 * <pre>
 * line 0      the number of the frame
 * frame 0     meanmax, players, radius of the arena, of the water, looters of a player          one a line
 * then        a score per player, a rage per player, nine messages     one a line
 * an impact   #time, then one unit, which met the wall, or two
 * sunk        #time, a tanker with a d, and its wreck if it left one
 * the end     #1.00000, then all units, wrecks and effects, then what has gone in the turn, with a d
 * a unit      id x y vx vy            id@water of a tanker; when it is new also kind radius, and player of a looter
 * a wreck     id@water                before the harvest of the turn; when it is new id@water x y 0 0 4 radius
 * an effect   id                      when it is new id x y looter 0 type radius
 * </pre>
 */
final class MeanMaxViews implements ViewWriter {

    private static final int LONGEST_MESSAGE = 19;
    private static final int KEPT = 17;

    private MeanMax game;
    private MeanMaxMoments moments;
    private final Set<Integer> known = new TreeSet<>();
    private final List<SkillEffect> effects = new ArrayList<>();
    private List<Integer> effectsBefore = List.of();
    private List<Wreck> wrecksBefore = List.of();
    private final Map<Integer, Integer> waterBefore = new TreeMap<>();
    private int scoreBefore;

    @Override
    public List<String> notCompared() {
        return List.of("gameInformation, tooltips, texts in colour",
            "messages of a player who fails, and the word behind the number of that frame");
    }

    @Override
    public Scene observed(Scene scene) {
        return scene.withObserver((parts, advance) -> (bodies, sink) -> {
            effects.clear();
            effects.addAll(game.world().effects());
            moments = new MeanMaxMoments(bodies, known);
            advance.turn(bodies, new TeeSink(sink, moments));
            moments.end();
        });
    }

    @Override
    public void begin(Game of) {
        game = (MeanMax) of;
    }

    @Override
    public Frame start() {
        List<String> view = new ArrayList<>(List.of(ANY, "meanmax", Integer.toString(game.players()),
            Long.toString(Math.round(MeanMaxWorld.ARENA_RADIUS)), Long.toString(Math.round(MeanMaxWorld.WATER_RADIUS)),
            Integer.toString(UnitKind.LOOTERS)));
        addPlayers(view);
        view.addAll(Collections.nCopies(game.players() * UnitKind.LOOTERS, ""));
        MeanMaxMoments units = new MeanMaxMoments(game.bodies(), known);
        units.end();
        view.addAll(units.lines());
        return new Frame(view, List.of());
    }

    private void addPlayers(List<String> view) {
        IntStream.range(0, game.players()).map(game::score).mapToObj(Integer::toString).forEach(view::add);
        IntStream.range(0, game.players()).map(game::rage).mapToObj(Integer::toString).forEach(view::add);
    }

    @Override
    public void before() {
        effectsBefore = game.world().effects().stream().map(SkillEffect::id).toList();
        wrecksBefore = List.copyOf(game.world().wrecks());
        waterBefore.clear();
        wrecksBefore.forEach(wreck -> waterBefore.put(wreck.id(), wreck.water()));
        scoreBefore = totalScore();
        if (game.turn() == 0) {
            IntStream.range(0, game.bodies().size()).map(game.bodies()::id).forEach(known::add);
        }
    }

    private int totalScore() {
        int total = 0;
        for (int player = 0; player < game.players(); player++) {
            total += game.score(player);
        }
        return total;
    }

    @Override
    public Frame after(String[] messages, List<String> shown) {
        boolean failed = false;
        for (int player = 0; player < game.players(); player++) {
            failed |= !game.isIn(player);
        }
        boolean ends = game.isOver() && game.turn() >= game.settings().maximumTurns();
        List<String> view = new ArrayList<>(List.of(ANY + " "
            + (failed ? REST : ends ? "maxRoundsCountReached" : "")));
        addPlayers(view);
        for (int player = 0; player < game.players(); player++) {
            ShownMessages said = new ShownMessages(messages[player], LONGEST_MESSAGE, KEPT, "...");
            for (int looter = 0; looter < UnitKind.LOOTERS; looter++) {
                int line = view.size();
                String text = line < shown.size() ? shown.get(line) : "";
                view.add(game.isIn(player) ? said.next(text, looter == UnitKind.LOOTERS - 1) : REST);
            }
        }
        List<String> gone = new ArrayList<>();
        addUnits(view, gone);
        addWrecks(view, gone);
        addEffects(view, gone);
        view.addAll(gone);
        return new Frame(view, ends ? List.of(REST) : List.of());
    }

    /** Units as they were before rounding and friction, with the water that tankers have after the turn. */
    private void addUnits(List<String> view, List<String> gone) {
        Bodies bodies = game.bodies();
        view.addAll(moments.before());
        for (int k = 0; k < moments.atEnd().size(); k++) {
            int unit = bodies.indexOf(moments.idAtEnd(k));
            String line = moments.atEnd().get(k);
            if (unit < 0) {
                gone.add(line + " d");
            } else if (game.world().isTanker(unit)) {
                line = bodies.id(unit) + "@" + (int) bodies.columns[MeanMaxWorld.WATER][unit]
                    + line.substring(line.indexOf(' '));
            }
            view.add(line);
        }
    }

    /** The water of wrecks before the harvest of the turn; of those that are empty after it, after it. */
    private void addWrecks(List<String> view, List<String> gone) {
        List<Wreck> wrecks = game.world().wrecks();
        List<String> emptied = new ArrayList<>();
        waterBefore.forEach((id, water) -> view.add(id + "@" + water));
        for (int k = 0; k < game.log().facts(); k++) {
            if (game.log().factKind(k) == Sinking.WRECK) {
                int id = game.log().factB(k);
                int full = (int) game.log().factP(k);
                view.add(id + "@" + full);
                if (wrecks.stream().noneMatch(wreck -> wreck.id() == id)) {
                    emptied.add(id + "@" + (full - harvestedFromOthers()) + " d");
                }
            }
        }
        wrecksBefore.stream().filter(wreck -> !wrecks.contains(wreck))
            .forEach(wreck -> emptied.add(wreck.id() + "@" + wreck.water() + " d"));
        gone.addAll(emptied);
    }

    /** Water harvested in this turn, but for that of a wreck that came and went in it. */
    private int harvestedFromOthers() {
        int harvested = totalScore() - scoreBefore;
        for (Wreck wreck : wrecksBefore) {
            harvested -= waterBefore.get(wreck.id()) - wreck.water();
        }
        for (int k = 0; k < game.log().facts(); k++) {
            for (Wreck wreck : game.world().wrecks()) {
                harvested -= game.log().factKind(k) == Sinking.WRECK && game.log().factB(k) == wreck.id()
                    ? (int) game.log().factP(k) - wreck.water() : 0;
            }
        }
        return harvested;
    }

    private void addEffects(List<String> view, List<String> gone) {
        for (SkillEffect effect : effects) {
            view.add(effectsBefore.contains(effect.id()) ? Integer.toString(effect.id()) : effect.id() + " "
                + (int) effect.x() + " " + (int) effect.y() + " " + effect.looter() + " 0 " + effect.skill().type()
                + " " + (int) MeanMaxWorld.SKILL_RADIUS);
            if (!game.world().effects().contains(effect)) {
                gone.add(effect.id() + " d");
            }
        }
    }
}
