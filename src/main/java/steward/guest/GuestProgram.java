package steward.guest;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import steward.bot.command.ProgramFinder;
import steward.scene.SceneReader;
import steward.scene.json.Block;

/**
 * The block {@code referee} of a scene.
 *
 * @param command      the program and its arguments
 * @param properties   lines {@code key=value} of the block INIT behind that of the seed, in the order of the keys
 * @param limitMs      how long the referee may take each time that it speaks, its start included
 * @param undetermined blocks that are not the same when a game is played again; they are not recorded
 */
record GuestProgram(List<String> command, Map<String, String> properties, int limitMs,
                    Set<steward.guest.Block.Name> undetermined) {

    private static final int USUAL_LIMIT_MS = 30_000;
    private static final int MOST_LIMIT_MS = 3_600_000;
    private static final Set<steward.guest.Block.Name> FOR_PEOPLE = EnumSet.of(steward.guest.Block.Name.VIEW,
        steward.guest.Block.Name.INFOS, steward.guest.Block.Name.SUMMARY, steward.guest.Block.Name.TOOLTIP,
        steward.guest.Block.Name.UINPUT, steward.guest.Block.Name.METADATA);

    /** Reads the block of a scene. */
    static GuestProgram read(Block root) {
        Block block = root.block(SceneReader.REFEREE);
        List<String> command = block.texts("command");
        if (command.isEmpty()) {
            throw block.error("command", "no words", "a program and its arguments");
        }
        Map<String, String> properties = new TreeMap<>();
        block.optionalBlock("properties").ifPresent(values -> {
            for (String key : values.entries().keySet()) {
                properties.put(key, values.text(key));
            }
        });
        properties.forEach((key, value) -> {
            if ((key + value).chars().anyMatch(Character::isISOControl) || key.contains("=")) {
                throw block.error("properties", "the property '" + key + "'", "keys and values of one line");
            }
        });
        int limitMs = block.integer("limitMs", 1, MOST_LIMIT_MS, USUAL_LIMIT_MS);
        Set<steward.guest.Block.Name> undetermined = EnumSet.noneOf(steward.guest.Block.Name.class);
        for (String word : block.contains("undetermined") ? block.texts("undetermined") : List.<String>of()) {
            undetermined.add(FOR_PEOPLE.stream().filter(name -> name.name().equals(word)).findFirst()
                .orElseThrow(() -> block.error("undetermined", "\"" + word + "\"", "blocks of " + FOR_PEOPLE)));
        }
        return new GuestProgram(command, properties, limitMs, undetermined);
    }

    /** The lines of the block INIT. */
    List<String> init(int players, long seed) {
        List<String> lines = new ArrayList<>();
        lines.add(Integer.toString(players));
        lines.add("seed=" + seed);
        properties.forEach((key, value) -> lines.add(key + "=" + value));
        return lines;
    }

    /** The command with the program's path; {@code null} if there is no such program. */
    List<String> resolved() {
        Path program = ProgramFinder.find(command.get(0));
        if (program == null) {
            return null;
        }
        List<String> words = new ArrayList<>(command);
        words.set(0, program.toString());
        return words;
    }
}
