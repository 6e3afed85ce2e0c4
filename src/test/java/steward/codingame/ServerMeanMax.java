package steward.codingame;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import steward.game.TextCodec;
import steward.game.TurnEvent;
import steward.game.meanmax.MeanMax;
import steward.game.meanmax.MeanMaxWorld;
import steward.game.meanmax.Sinking;
import steward.game.meanmax.SkillEffect;
import steward.game.meanmax.Wreck;
import steward.match.TestScenes;
import steward.physics.Bodies;
import steward.physics.Impact;
import steward.physics.Motion;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/** Writes a game of Mean Max played here in the form of CodinGame's own JSON; speeds after turns are shown as 0. */
public final class ServerMeanMax {

    private static final int SKILL_EVERY = 7;

    private final ObjectNode result = JsonMapper.shared().createObjectNode();
    private final ArrayNode frames = result.putArray("frames");
    private final Set<Integer> known = new TreeSet<>();
    private final MeanMax game;
    private final TextCodec codec;
    private int impacts;
    private int sunk;

    private ServerMeanMax(long seed) {
        game = (MeanMax) TestScenes.open("mean-max").create(seed);
        codec = TestScenes.open("mean-max").textCodec(game).orElseThrow();
        result.put("refereeInput", "seed=" + seed + "\n");
        StringBuilder view = new StringBuilder(" 0\nmeanmax\n3\n6000\n3000\n3\n");
        players(view);
        view.append("#1.00000\n");
        for (int unit = 0; unit < game.bodies().size(); unit++) {
            unit(view, unit, (long) game.bodies().vx[unit], (long) game.bodies().vy[unit]);
        }
        frames.addObject().put("view", view.toString()).put("keyframe", true).put("agentId", -1);
    }

    /** So many turns, or fewer if the game is over before: reapers to the centre, the others to tankers, and tar. */
    public static ServerMeanMax play(long seed, int turns) {
        ServerMeanMax of = new ServerMeanMax(seed);
        for (int turn = 0; turn < turns && !of.game.isOver(); turn++) {
            of.turn();
        }
        if (of.game.isOver()) {
            of.finish();
        }
        return of;
    }

    private void finish() {
        ArrayNode scores = result.putArray("scores");
        List<Integer> order = new ArrayList<>();
        for (int player = 0; player < game.players(); player++) {
            scores.add((double) game.score(player));
            order.add(player);
        }
        order.sort((one, other) -> game.score(other) - game.score(one));
        order.forEach(result.putArray("ranks")::add);
    }

    /** A copy that tests may change. */
    ObjectNode gameResult() {
        return result.deepCopy();
    }

    /** As it is downloaded. */
    public String json() {
        ObjectNode whole = JsonMapper.shared().createObjectNode();
        whole.set("success", result);
        return whole.toString();
    }

    int impacts() {
        return impacts;
    }

    int sunk() {
        return sunk;
    }

    int turns() {
        return game.turn();
    }

    private String answer(int player) {
        Bodies bodies = game.bodies();
        int tanker = Math.min(bodies.size() - 1, MeanMaxWorld.looter(2, 2) + 1 + player);
        String there = (long) bodies.x[tanker] + " " + (long) bodies.y[tanker] + " 300";
        boolean skill = game.turn() % SKILL_EVERY == player && game.rage(player) >= 30;
        int reaper = MeanMaxWorld.looter(player, 0);
        return (skill ? "SKILL " + (long) bodies.x[reaper] + " " + (long) bodies.y[reaper] : "0 0 300") + "\n" + there
            + "\n" + there + " hello";
    }

    private void turn() {
        for (int player = 0; player < game.players(); player++) {
            String answer = answer(player);
            byte[] bytes = answer.getBytes(StandardCharsets.UTF_8);
            String wrong = codec.readAnswer(player, bytes, bytes.length);
            if (wrong != null) {
                throw new AssertionError(wrong);
            }
            frames.addObject().put("stdout", answer + "\n").put("keyframe", player == game.players() - 1)
                .put("agentId", player).put("view", " " + (frames.size() - 1) + "\n");
        }
        List<SkillEffect> effects = game.world().effects().stream().toList();
        Map<Integer, Integer> water = new TreeMap<>();
        List<Wreck> wrecks = List.copyOf(game.world().wrecks());
        wrecks.forEach(wreck -> water.put(wreck.id(), wreck.water()));
        game.play();
        StringBuilder view = new StringBuilder(" " + (frames.size() - 1) + "\n");
        players(view);
        moments(view, water);
        view.append("#1.00000\n");
        end(view, effects, wrecks, water);
        ((ObjectNode) frames.get(frames.size() - 1)).put("view", view.toString());
    }

    private void players(StringBuilder view) {
        for (int player = 0; player < game.players(); player++) {
            view.append(game.score(player)).append('\n');
        }
        for (int player = 0; player < game.players(); player++) {
            view.append(game.rage(player)).append('\n');
        }
        view.append("\n".repeat(9));
    }

    private void moments(StringBuilder view, Map<Integer, Integer> water) {
        for (int k = 0; k < game.log().impacts(); k++) {
            Impact impact = game.log().impact(k);
            impacts++;
            view.append(time(impact.time()));
            met(view, impact.a(), impact.ax(), impact.ay(), impact.vaxBefore(), impact.vayBefore());
            if (!impact.isWall()) {
                met(view, impact.b(), impact.bx(), impact.by(), impact.vbxBefore(), impact.vbyBefore());
            }
        }
        for (int k = 0; k < game.log().facts(); k++) {
            if (game.log().factKind(k) == Sinking.SUNK) {
                sunk++;
                view.append(time(game.log().factTime(k))).append(game.log().factA(k)).append("@1 ")
                    .append(round(game.log().factX(k))).append(' ').append(round(game.log().factY(k)))
                    .append(" 0 0 d\n");
            } else {
                water.put(game.log().factB(k), (int) game.log().factP(k));
                view.append(game.log().factB(k)).append('@').append((int) game.log().factP(k)).append(' ')
                    .append(round(game.log().factX(k))).append(' ').append(round(game.log().factY(k)))
                    .append(" 0 0 4 ").append(game.log().factQ(k)).append('\n');
            }
        }
    }

    private void end(StringBuilder view, List<SkillEffect> effects, List<Wreck> wrecks, Map<Integer, Integer> water) {
        StringBuilder gone = new StringBuilder();
        List<Integer> born = new ArrayList<>();
        for (TurnEvent event : game.events()) {
            if (event.kind() == TurnEvent.Kind.BIRTH) {
                born.add(event.body());
            } else if (event.text().startsWith("left")) {
                String line = event.body() + "@9 " + round(event.x()) + " " + round(event.y()) + " 0 0";
                view.append(line).append('\n');
                gone.append(line).append(" d\n");
            }
        }
        for (int unit = 0; unit < game.bodies().size(); unit++) {
            if (!born.contains(game.bodies().id(unit))) {
                unit(view, unit, 0, 0);
            }
        }
        water.forEach((id, left) -> {
            view.append(id).append('@').append(left).append('\n');
            if (game.world().wrecks().stream().noneMatch(wreck -> wreck.id() == id)) {
                gone.append(id).append("@0 d\n");
            }
        });
        List<Integer> before = effects.stream().map(SkillEffect::id).toList();
        for (SkillEffect effect : game.world().effects()) {
            view.append(effect.id());
            if (!before.contains(effect.id())) {
                view.append(' ').append((long) effect.x()).append(' ').append((long) effect.y()).append(' ')
                    .append(effect.looter()).append(" 0 ").append(effect.skill().type()).append(" 1000");
            }
            view.append('\n');
        }
        for (SkillEffect effect : effects) {
            if (game.world().effects().stream().noneMatch(after -> after.id() == effect.id())) {
                view.append(effect.id()).append('\n');
                gone.append(effect.id()).append(" d\n");
            }
        }
        view.append(gone);
    }

    private static String time(double time) {
        return String.format(Locale.ROOT, "#%.5f%n", time).replace("\r", "");
    }

    private static long round(double value) {
        return (long) Motion.roundHalfAway(value);
    }

    /** A tanker that has not been shown yet is so in the block of the turn's end: here it is shown first. */
    private void met(StringBuilder view, int id, double x, double y, double vx, double vy) {
        int unit = game.bodies().indexOf(id);
        boolean tanker = id > MeanMaxWorld.looter(2, 2);
        view.append(id).append(tanker ? "@1 " : " ").append(round(x)).append(' ').append(round(y)).append(' ')
            .append(round(vx)).append(' ').append(round(vy));
        if (unit >= 0) {
            what(view, unit);
        }
        view.append('\n');
    }

    private void unit(StringBuilder view, int unit, long vx, long vy) {
        Bodies bodies = game.bodies();
        view.append(bodies.id(unit));
        if (game.world().isTanker(unit)) {
            view.append('@').append((int) bodies.columns[MeanMaxWorld.WATER][unit]);
        }
        view.append(' ').append((long) bodies.x[unit]).append(' ').append((long) bodies.y[unit]).append(' ').append(vx)
            .append(' ').append(vy);
        what(view, unit);
        view.append('\n');
    }

    private void what(StringBuilder view, int unit) {
        Bodies bodies = game.bodies();
        if (known.add(bodies.id(unit))) {
            view.append(' ').append(bodies.kind[unit]).append(' ').append((long) bodies.radius[unit]);
            if (!game.world().isTanker(unit)) {
                view.append(' ').append(game.playerOf(bodies.id(unit)));
            }
        }
    }
}
