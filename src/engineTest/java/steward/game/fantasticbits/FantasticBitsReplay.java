package steward.game.fantasticbits;

import java.util.List;
import java.util.Locale;
import java.util.TreeSet;
import steward.game.VectorMatch;
import steward.game.VectorReplay;
import steward.game.fantasticbits.protocol.FantasticBitsType;
import steward.physics.Bodies;
import steward.physics.Impact;
import steward.physics.TurnLog;
import steward.scene.SceneFiles;
import steward.scene.SceneReader;
import tools.jackson.databind.JsonNode;

/** A match of the published Fantastic Bits referee, played again. */
public final class FantasticBitsReplay extends VectorReplay<FantasticBits> {

    private static final List<String> SIDES = List.of("LEFT", "TOP", "RIGHT", "BOTTOM");
    private static final FantasticBitsType.FantasticBitsSetup PUZZLE = open("fantastic-bits");
    private static final FantasticBitsType.FantasticBitsSetup CONTEST = open("fantastic-bits-contest");

    public FantasticBitsReplay(VectorMatch match) {
        super(match, setup(match));
    }

    private static FantasticBitsType.FantasticBitsSetup open(String scene) {
        return new FantasticBitsType().open(SceneReader.read(SceneFiles.load(scene), null));
    }

    static FantasticBitsType.FantasticBitsSetup setup(Variant variant) {
        return variant == Variant.PUZZLE ? PUZZLE : CONTEST;
    }

    /** The shipped scene, in the league of the match. */
    private static FantasticBitsType.FantasticBitsSetup setup(VectorMatch match) {
        JsonNode header = match.header();
        Variant variant = Variant.valueOf(header.get("variant").asString().toUpperCase(Locale.ROOT));
        if (!header.has("spells")) {
            return setup(variant);
        }
        String text = setup(variant).scene().json().replace("\"maximumTurns\":", "\"spells\":" + header.get("spells")
            + ",\"bludgers\":" + header.get("bludgers") + ",\"maximumTurns\":");
        return new FantasticBitsType().open(SceneReader.read(text, match.name()));
    }

    @Override
    protected FantasticBits create() {
        return ((FantasticBitsType.FantasticBitsSetup) setup).create(match.seed());
    }

    @Override
    protected void compareStart(FantasticBits game) {
        comparison.same("score to win", match.header().get("scoreToWin").asInt(), game.winningScore());
    }

    @Override
    protected Object score(FantasticBits game, int player) {
        return game.score(player);
    }

    @Override
    protected FantasticBits in(FantasticBits game, JsonNode state) {
        Pitch pitch = new Pitch(state.get("snaffles").size(), state.get("bludgers").size());
        Bodies bodies = pitch.bodies();
        for (JsonNode wizard : state.get("wizards")) {
            int self = move(bodies, wizard);
            bodies.columns[Pitch.HELD][self] = wizard.get("snaffle").asInt();
            bodies.columns[Pitch.WAIT][self] = wizard.get("captureWait").asInt();
            for (Spell spell : Spell.values()) {
                pitch.spells().set(self, spell, wizard.get(spell.text()).get(0).asInt(),
                    wizard.get(spell.text()).get(1).asInt());
            }
            JsonNode cast = wizard.get("cast");
            if (!cast.isNull()) {
                pitch.spells().cast(self, Spell.valueOf(cast.get(0).asString().toUpperCase(Locale.ROOT)),
                    cast.get(1).asInt());
            }
        }
        for (JsonNode snaffle : state.get("snaffles")) {
            int self = move(bodies, snaffle);
            bodies.setKind(self, (!snaffle.get("alive").asBoolean() ? EntityKind.LOST_SNAFFLE
                : snaffle.get("captured").asBoolean() ? EntityKind.HELD_SNAFFLE : EntityKind.SNAFFLE).ordinal());
            snaffle.get("ignores").forEach(other -> Pitch.ignore(bodies, self, other.asInt()));
        }
        for (JsonNode bludger : state.get("bludgers")) {
            bodies.columns[Pitch.LAST_VICTIM][move(bodies, bludger)] = bludger.get("lastVictim").asInt();
        }
        int[] scores = new int[2];
        int[] magic = new int[2];
        for (int player = 0; player < 2; player++) {
            scores[player] = state.get("scores").get(player).asInt();
            magic[player] = state.get("magic").get(player).asInt();
        }
        return Pitches.game(game, pitch, scores, magic);
    }

    private static int move(Bodies bodies, JsonNode entity) {
        int self = entity.get("id").asInt();
        bodies.setPosition(self, entity.get("x").asDouble(), entity.get("y").asDouble());
        bodies.setVelocity(self, entity.get("vx").asDouble(), entity.get("vy").asDouble());
        return self;
    }

    /** Captures, goals and open goals are facts. */
    @Override
    protected boolean isFact(JsonNode of, TurnLog log, int fact) {
        return of.get("kind").asString().matches("capture|goal") || isOpen(of, log, fact);
    }

    private static boolean isOpen(JsonNode of, TurnLog log, int fact) {
        return of.get("kind").asString().equals("wall") && fact < log.facts() && of.get("force").asDouble() == 0
            && log.factKind(fact) == Captures.OPEN_GOAL && log.factA(fact) == of.get("a").asInt();
    }

    @Override
    protected int compareFact(String what, JsonNode of, TurnLog log, int fact) {
        boolean open = isOpen(of, log, fact);
        boolean goal = of.get("kind").asString().equals("goal");
        int expected = open ? Captures.OPEN_GOAL : goal ? Captures.GOAL : Captures.CAPTURE;
        comparison.same(what + "kind", expected, log.factKind(fact));
        comparison.same(what + "t", of.get("t").asDouble(), log.factTime(fact));
        comparison.same(what + "a", of.get("a").asInt(), log.factA(fact));
        comparison.same(what + "b", open ? SIDES.indexOf(of.get("side").asString())
            : of.get(goal ? "player" : "b").asInt(), log.factB(fact));
        return 1;
    }

    @Override
    protected void compareImpact(String what, JsonNode of, Impact impact) {
        comparison.same(what + "t", of.get("t").asDouble(), impact.time());
        comparison.same(what + "a", of.get("a").asInt(), impact.a());
        boolean wall = of.get("kind").asString().equals("wall");
        comparison.same(what + "is wall", wall, impact.isWall());
        if (wall) {
            comparison.same(what + "side", of.get("side").asString(), SIDES.get(impact.wall()));
            double force = impact.normalX() + impact.normalY() < 0 ? 0.0 - impact.impulse() : impact.impulse();
            comparison.same(what + "force", of.get("force").asDouble() + 0.0, force + 0.0);
        } else {
            comparison.same(what + "b", of.get("b").asInt(), impact.b());
            if (of.has("force")) {
                comparison.same(what + "force", of.get("force").asDouble(), impact.impulse());
            }
        }
    }

    @Override
    protected void compareState(String when, JsonNode state, FantasticBits game) {
        Pitch pitch = game.pitch();
        Bodies bodies = pitch.bodies();
        for (int player = 0; player < game.players(); player++) {
            String what = when + " player " + player + " ";
            comparison.same(what + "score", state.get("scores").get(player).asInt(), game.score(player));
            comparison.same(what + "magic", state.get("magic").get(player).asInt(), game.magic(player));
            comparison.same(what + "is out", state.get("dead").get(player).asBoolean(), !game.isIn(player));
        }
        comparison.same(when + " snaffles", state.get("snaffles").size(), pitch.snaffles());
        for (JsonNode wizard : state.get("wizards")) {
            int id = wizard.get("id").asInt();
            String what = when + " wizard " + id + " ";
            compareMotion(what, wizard, bodies);
            comparison.fields(what, wizard, "player", Pitch.playerOf(id), "snaffle", pitch.held(id),
                "captureWait", bodies.columns[Pitch.WAIT][id]);
            for (Spell spell : Spell.values()) {
                comparison.same(what + spell.text(), numbers(wizard.get(spell.text())),
                    List.of(pitch.spells().turns(id, spell), pitch.spells().target(id, spell)));
            }
            JsonNode cast = wizard.get("cast");
            comparison.same(what + "cast", cast.isNull() ? "none" : cast.get(0).asString() + cast.get(1).asInt(),
                pitch.spells().cast(id) == null ? "none"
                    : pitch.spells().cast(id).text() + pitch.spells().castAt(id));
        }
        for (JsonNode snaffle : state.get("snaffles")) {
            int id = snaffle.get("id").asInt();
            String what = when + " snaffle " + id + " ";
            compareMotion(what, snaffle, bodies);
            comparison.same(what + "alive", snaffle.get("alive").asBoolean(),
                pitch.kind(id) != EntityKind.LOST_SNAFFLE);
            comparison.same(what + "captured", snaffle.get("captured").asBoolean(), isHeld(pitch, id));
            TreeSet<Integer> found = new TreeSet<>();
            for (int other = Pitch.WIZARDS; other < Pitch.WIZARDS + pitch.snaffles(); other++) {
                if (Pitch.ignores(bodies, id, other)) {
                    found.add(other);
                }
            }
            comparison.same(what + "ignores", new TreeSet<>(numbers(snaffle.get("ignores"))), found);
        }
        for (JsonNode bludger : state.get("bludgers")) {
            int id = bludger.get("id").asInt();
            compareMotion(when + " bludger " + id + " ", bludger, bodies);
            comparison.same(when + " bludger " + id + " last victim", bludger.get("lastVictim").asDouble(),
                bodies.columns[Pitch.LAST_VICTIM][id]);
        }
    }

    private static boolean isHeld(Pitch pitch, int snaffle) {
        for (int wizard = 0; wizard < Pitch.WIZARDS; wizard++) {
            if (pitch.held(wizard) == snaffle) {
                return true;
            }
        }
        return false;
    }

    private void compareMotion(String what, JsonNode entity, Bodies bodies) {
        int id = entity.get("id").asInt();
        comparison.fields(what, entity, "x", bodies.x[id], "y", bodies.y[id], "vx", bodies.vx[id],
            "vy", bodies.vy[id]);
    }
}
