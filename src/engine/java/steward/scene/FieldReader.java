package steward.scene;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import steward.physics.Arena;
import steward.physics.HalfPlane;
import steward.physics.Segment;
import steward.physics.Wall;
import steward.scene.json.Block;
import steward.text.NearestName;

/** Reader of a scene's block {@code field}. */
final class FieldReader {

    /** Kinds of walls in a list; a box is four of them. */
    private static final Map<String, Function<Block, Wall>> WALLS = Map.of("segment", FieldReader::segment,
        "half-plane", FieldReader::halfPlane, "arena", FieldReader::arena, "box", box -> null);

    static Field read(Block block) {
        double x = block.number("x", -Block.MAXIMUM, Block.MAXIMUM, 0);
        double y = block.number("y", -Block.MAXIMUM, Block.MAXIMUM, 0);
        double width = block.positive("width");
        double height = block.positive("height");
        return new Field(x, y, width, height, walls(block, x, y, width, height), bumpers(block));
    }

    /** {@code "box"}, a box with a restitution, or an array of walls; no walls when absent. */
    private static List<Wall> walls(Block block, double x, double y, double width, double height) {
        Map<String, Boolean> box = Map.of("box", true);
        if (!block.has("walls")) {
            return List.of();
        }
        if (block.isText("walls")) {
            if (!block.text("walls").equals("box")) {
                throw block.error("walls", block.shown("walls"), "\"box\" or an array of walls, each of the \"type\" "
                    + "\"arena\", \"box\", \"half-plane\" or \"segment\"" + NearestName.question(block.text("walls"),
                    WALLS.keySet(), "\""));
            }
            return List.of(Wall.box(x, y, width, height, 1));
        }
        if (block.isArray("walls")) {
            List<Wall> walls = new ArrayList<>();
            for (Block wall : block.blocks("walls")) {
                Wall single = single(wall);
                walls.addAll(List.of(single == null ? Wall.box(x, y, width, height, restitution(wall))
                    : new Wall[] {single}));
            }
            return walls;
        }
        if (!block.isBlock("walls")) {
            throw block.error("walls", block.shown("walls"), "\"box\", an object or an array of walls");
        }
        Block wall = block.block("walls");
        wall.choice("type", box);
        return List.of(Wall.box(x, y, width, height, restitution(wall)));
    }

    /** Returns {@code null} for a box. */
    private static Wall single(Block wall) {
        Function<Block, Wall> kind = wall.choice("type", WALLS);
        try {
            return kind.apply(wall);
        } catch (IllegalArgumentException refusal) {
            throw wall.error(refusal);
        }
    }

    private static Wall segment(Block wall) {
        return new Segment(finite(wall, "ax"), finite(wall, "ay"), finite(wall, "bx"), finite(wall, "by"),
            restitution(wall));
    }

    private static Wall halfPlane(Block wall) {
        return new HalfPlane(finite(wall, "x"), finite(wall, "y"), finite(wall, "insideX"), finite(wall, "insideY"),
            restitution(wall));
    }

    private static Wall arena(Block wall) {
        return new Arena(finite(wall, "x"), finite(wall, "y"), wall.positive("radius"), restitution(wall));
    }

    private static List<Bumper> bumpers(Block block) {
        return !block.has("bumpers") ? List.of() : block.blocks("bumpers").stream().map(bumper -> new Bumper(
            finite(bumper, "x"), finite(bumper, "y"), bumper.positive("radius"), restitution(bumper))).toList();
    }

    private static double finite(Block block, String name) {
        return block.number(name, -Block.MAXIMUM, Block.MAXIMUM);
    }

    private static double restitution(Block block) {
        return block.number("restitution", 0, 1, 1);
    }
}
