package steward.game.bodies.protocol;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import steward.game.bodies.Body;
import steward.game.bodies.Fill;
import steward.game.bodies.Layout;
import steward.game.bodies.PlayRules;
import steward.game.bodies.Zone;
import steward.physics.Forces;
import steward.scene.Field;
import steward.scene.Scene;
import steward.scene.json.Block;

/** Reader of a scene's blocks {@code bodies} and {@code play}, with a check of the places of the listed discs. */
final class BodiesReader {

    private static final int MOST_TURNS = 1_000_000;
    private static final int MOST_BODIES = 200_000;
    private static final int MOST_POINTS = 1000;
    private static final int LONGEST_LABEL = 20;
    private static final Map<String, Fill.Shape> SHAPES = Map.of("random", Fill.Shape.RANDOM,
        "lattice", Fill.Shape.LATTICE, "ring", Fill.Shape.RING, "line", Fill.Shape.LINE);
    private static final Map<String, Boolean> WHEN = Map.of("passing", true, "resting", false);

    private final Scene scene;
    private final Field field;
    private final Block bodies;
    /** Where errors about each listed disc are located. */
    private final List<Block> places = new ArrayList<>();
    private final List<Block> fillBlocks = new ArrayList<>();
    /** Places in the file of listed discs with infinite mass, by index. */
    private final Map<Integer, String> unstoppable = new TreeMap<>();

    BodiesReader(Scene scene) {
        this.scene = scene;
        field = scene.field().orElseThrow(() -> scene.root().error("field", "nothing", "the field of the bodies"));
        bodies = scene.root().block("bodies");
    }

    /** Reads the block {@code bodies}; a disc that overlaps with another or with a wall is refused. */
    Layout layout() {
        List<Body> listed = new ArrayList<>();
        if (bodies.has("listed")) {
            bodies.blocks("listed").forEach(block -> listed.add(listed(block)));
        }
        if (bodies.has("csv")) {
            if (!bodies.isBlock("csv") || !bodies.block("csv").has("lines")) {
                throw bodies.error("csv", bodies.shown("csv"), "the name of a file beside the scene");
            }
            for (Block row : new CsvRows(bodies.block("csv")).blocks()) {
                listed.add(listed(row));
                row.done();
            }
        }
        List<Fill> fills = new ArrayList<>();
        if (bodies.isArray("fill")) {
            bodies.blocks("fill").forEach(block -> fills.add(fill(block)));
        } else if (bodies.has("fill")) {
            fills.add(fill(bodies.block("fill")));
        }
        Layout layout = new Layout(field, listed, fills);
        if (layout.count() == 0) {
            throw bodies.error("no body", "bodies that are listed, in a csv or laid out by a fill");
        }
        if (layout.count() > MOST_BODIES) {
            throw bodies.error(layout.count() + " bodies", "at most " + MOST_BODIES);
        }
        for (int player = 0; player < scene.players(); player++) {
            int owner = player;
            if (listed.stream().noneMatch(body -> body.owner() == owner)
                && fills.stream().noneMatch(fill -> fill.like().owner() == owner)) {
                throw scene.root().error("players", "no body whose owner is player " + player, "one or more");
            }
        }
        layout.check(new Layout.Misplaced() {
            @Override
            public void overlap(int body, int other) {
                int bumpers = field.bumpers().size();
                throw places.get(body).error("a place that overlaps with " + (other < bumpers ? "bumper " + other
                    : named(places.get(other - bumpers), listed.get(other - bumpers))), "a place of its own");
            }

            @Override
            public void wall(int body, int wall) {
                throw places.get(body).error("a place in or behind wall " + wall, "one inside the walls");
            }
        });
        places.clear();
        return layout;
    }

    /** Warnings about bodies of infinite mass, which no wall holds, that leave the field before the last turn. */
    List<String> warnings(Layout layout, PlayRules rules) {
        List<String> warnings = new ArrayList<>();
        unstoppable.forEach((index, place) -> {
            Body body = layout.listed().get(index);
            double path = 0;
            double share = 1;
            for (int turn = 1; turn <= rules.maximumTurns(); turn++) {
                path += share;
                share *= 1 - body.drag();
                if (isOutside(body.x() + path * body.vx(), field.x(), field.width())
                    || isOutside(body.y() + path * body.vy(), field.y(), field.height())) {
                    warnings.add(place + ": found a body of infinite mass that leaves the field in turn " + turn
                        + " of " + rules.maximumTurns() + ", expected one that stays in it: no wall holds it");
                    return;
                }
            }
        });
        for (int k = 0; k < layout.fills().size(); k++) {
            Fill fill = layout.fills().get(k);
            if (fill.like().mass() == Double.POSITIVE_INFINITY) {
                String leaves = leaves(fill, rules.maximumTurns());
                if (!leaves.isEmpty()) {
                    warnings.add(fillBlocks.get(k).place() + ": found bodies of infinite mass that " + leaves
                        + ", expected ones that stay in it: no wall holds them");
                }
            }
        }
        return warnings;
    }

    /** Words for when the bodies of a fill leave the field, whatever is drawn; empty if none can. */
    private String leaves(Fill fill, int turns) {
        double path = 0;
        double share = 1;
        for (int turn = 1; turn <= turns; turn++) {
            path += share;
            share *= 1 - fill.like().drag();
            if (fill.speedLow() * path > field.width() + field.height()) {
                return "leave the field by turn " + turn + " of " + turns;
            }
        }
        double[] at = fill.place();
        boolean line = fill.shape() == Fill.Shape.LINE;
        boolean round = at.length == 3;
        double left = line ? Math.min(at[0], at[2]) : round ? at[0] - at[2] : at[0];
        double right = line ? Math.max(at[0], at[2]) : round ? at[0] + at[2] : at[0] + at[2];
        double top = line ? Math.min(at[1], at[3]) : round ? at[1] - at[2] : at[1];
        double bottom = line ? Math.max(at[1], at[3]) : round ? at[1] + at[2] : at[1] + at[3];
        double far = fill.speedHigh() * path;
        return isOutside(left - far, field.x(), field.width()) || isOutside(right + far, field.x(), field.width())
            || isOutside(top - far, field.y(), field.height()) || isOutside(bottom + far, field.y(), field.height())
            ? "may leave the field within " + turns + " turns" : "";
    }

    private static boolean isOutside(double at, double from, double size) {
        return at < from || at > from + size;
    }

    /** A body as its file names it: with its label, and where it stands. */
    private static String named(Block block, Body body) {
        return "the body " + (body.label().isEmpty() ? "" : "\"" + body.label() + "\" ") + "at " + block.place();
    }

    private Body listed(Block block) {
        Body like = like(block);
        if (like.mass() == Double.POSITIVE_INFINITY) {
            unstoppable.put(places.size(), block.place());
        }
        places.add(block);
        return new Body(finite(block, "x"), finite(block, "y"), speed(block, "vx"), speed(block, "vy"),
            block.positive("radius"), like.mass(), like.restitution(), like.drag(), like.owner(), like.label(),
            like.colour());
    }

    /** Reads the fields that listed discs and fills have in common. */
    private Body like(Block block) {
        double mass = block.has("mass") ? block.mass("mass") : 1;
        String label = block.has("label") ? block.text("label") : "";
        if (label.length() > LONGEST_LABEL) {
            throw block.error("label", label.length() + " characters", "at most " + LONGEST_LABEL);
        }
        String colour = block.has("colour") ? block.text("colour") : "";
        if (!colour.isEmpty() && !colour.matches("#[0-9a-f]{6}")) {
            throw block.error("colour", block.shown("colour"), "a colour such as \"#cc3300\"");
        }
        int owner = Body.NOBODY;
        if (block.has("owner") && scene.players() == 0) {
            throw block.error("owner", block.shown("owner"), "none in a scene without players");
        } else if (block.has("owner")) {
            owner = block.integer("owner", 0, scene.players() - 1);
        }
        return new Body(0, 0, 0, 0, 0, mass, block.number("restitution", 0, 1, 1),
            block.number("drag", 0, 1, scene.drag()), owner, label, colour);
    }

    private Fill fill(Block block) {
        fillBlocks.add(block);
        Fill.Shape shape = block.choice("shape", SHAPES, Fill.Shape.RANDOM);
        double[] radius = range(block, "radius", 1 / Block.MAXIMUM);
        double[] speed = block.has("speed") ? range(block, "speed", 0) : new double[2];
        return new Fill(shape, block.integer("count", 1, MOST_BODIES), place(block, shape), radius[0], radius[1],
            speed[0], speed[1], like(block), block.has("seed") ? (long) block.integer("seed", 0, Integer.MAX_VALUE)
            : null);
    }

    /** A number, or an array of the least and the greatest. */
    private static double[] range(Block block, String name, double least) {
        if (!block.isArray(name)) {
            double value = block.number(name, least, Block.MAXIMUM);
            return new double[] {value, value};
        }
        double[] range = block.numbers(name, 2, least, Block.MAXIMUM);
        if (range[0] > range[1]) {
            throw block.error(name, range[0] + " before " + range[1], "the smaller one first");
        }
        return range;
    }

    private double[] place(Block block, Fill.Shape shape) {
        if (!block.has("in") && (shape == Fill.Shape.RANDOM || shape == Fill.Shape.LATTICE)) {
            return new double[] {field.x(), field.y(), field.width(), field.height()};
        }
        Block in = block.block("in");
        if (shape == Fill.Shape.LINE) {
            return new double[] {finite(in, "ax"), finite(in, "ay"), finite(in, "bx"), finite(in, "by")};
        }
        if (shape == Fill.Shape.RING || shape == Fill.Shape.RANDOM && in.contains("radius")) {
            return new double[] {finite(in, "x"), finite(in, "y"), in.positive("radius")};
        }
        return new double[] {finite(in, "x"), finite(in, "y"), in.positive("width"), in.positive("height")};
    }

    /** Reads the block {@code play}. */
    PlayRules rules() {
        Block play = scene.root().block("play");
        Block force = play.optionalBlock("force").orElse(null);
        Block gravity = play.optionalBlock("gravity").orElse(null);
        List<Zone> zones = new ArrayList<>();
        if (play.has("zones")) {
            play.blocks("zones").forEach(block -> zones.add(zone(block)));
        }
        boolean players = scene.players() > 0;
        return new PlayRules(play.integer("maximumTurns", 1, MOST_TURNS), play.number("restBelow", 0, Block.MAXIMUM, 0),
            new Forces(component(force, "x"), component(force, "y"), component(gravity, "x"),
                component(gravity, "y")),
            players ? play.positive("maximumThrust") : 0,
            players ? play.integer("contactPoints", 0, MOST_POINTS, 0) : 0, zones);
    }

    /** A zone; those that end the game or take bodies out are reached by passing, if the block does not say. */
    private static Zone zone(Block block) {
        boolean ends = block.flag("ends", false);
        boolean removes = block.flag("removes", false);
        return new Zone(finite(block, "x"), finite(block, "y"), block.positive("radius"), block.text("label"),
            block.integer("points", 0, MOST_POINTS, 0), ends, removes, block.choice("when", WHEN, ends || removes));
    }

    private static double component(Block block, String name) {
        return block == null ? 0 : finite(block, name);
    }

    /** The error for a fill that does not fit. */
    RuntimeException error(Layout.NoRoomException problem, int count) {
        return fillBlocks.get(problem.fill()).error("room for " + problem.placed() + " of " + count + " bodies",
            "room for all without overlap, inside the walls");
    }

    private static double finite(Block block, String name) {
        return block.number(name, -Block.MAXIMUM, Block.MAXIMUM);
    }

    private static double speed(Block block, String name) {
        return block.number(name, -Block.MAXIMUM, Block.MAXIMUM, 0);
    }
}
