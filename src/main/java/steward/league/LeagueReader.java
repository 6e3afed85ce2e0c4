package steward.league;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Function;
import java.util.regex.Pattern;
import steward.bot.TimeBasis;
import steward.bot.command.Platform;
import steward.bot.hold.HoldPolicy;
import steward.contest.Hiccups;
import steward.contest.KeptReplays;
import steward.match.OwnLimits;
import steward.scene.json.Block;
import steward.scene.json.JsonTree;
import steward.scene.json.JsonValue.Entry;
import steward.scene.json.JsonValue.JsonArray;
import steward.scene.json.JsonValue.JsonText;
import steward.scene.json.SceneException;
import steward.text.NearestName;

/** Reader and checker of league.json. An error gives line and column, what was found and what was expected. */
public final class LeagueReader {

    /** The version of the file's form. */
    static final int FORM = 1;
    static final String ROUND_ROBIN = "round-robin";
    static final String ADAPTIVE = "adaptive";
    static final String GAUNTLET = "gauntlet ";

    /** Form of a bot's name. */
    public static final Pattern NAME = Pattern.compile("[\\p{L}\\p{M}\\p{N}._-]{1,100}");
    /** Form of a bot's name, in words. */
    public static final String NAME_FORM = "1 to 100 letters, digits, dots, underscores and hyphens";

    static final String ANSWER = "answerMs";
    static final String FIRST_ANSWER = "firstAnswerMs";

    private static final double MOST_FACTOR = 1e6;
    private static final String BOTS = "bots";
    private static final String NAME_FIELD = "name";
    private static final String FOLDER = "folder";
    private static final String KEEP = "keep";
    private static final String PLATFORMS = "platforms";
    private static final String PLATFORM = "platform";
    private static final String PAIRING = "pairing";
    private static final String SEED = "seed";
    static final String SEEDS = "seeds";
    /** Name of a file without folders. */
    private static final Pattern FILE_NAME = Pattern.compile("[\\p{L}\\p{M}\\p{N}_-][\\p{L}\\p{M}\\p{N}._ -]*");
    private static final String FACTOR = "factor";
    private static final String HOLD = "hold";
    /** Name of the policy {@code always} before 0.2.0. */
    private static final String PAUSE = "pauseWaiting";

    private final Block root;

    private LeagueReader(Block root) {
        this.root = root;
    }

    /**
     * @param source how errors name the text
     * @throws SceneException if it is not what it should be
     */
    public static LeagueSettings read(String text, String source) {
        return new LeagueReader(new Block(source, "", JsonTree.read(text, source, "a league"))).settings();
    }

    private LeagueSettings settings() {
        root.integer("league", FORM, FORM);
        String scene = root.text("scene");
        long seed = seed();
        String seedFile = root.has(SEEDS) ? seedFile() : null;
        int lag = root.integer("lag", 1, LeagueSettings.MOST_LAG, LeagueSettings.USUAL_LAG);
        Block time = root.optionalBlock("time").orElse(null);
        Hiccups hiccups = root.choice("hiccups", words(Hiccups.values(), Hiccups::word), Hiccups.REPLAY);
        List<String> sandbox = root.optionalBlock("sandbox").map(LeagueReader::sandbox).orElse(List.of());
        List<LeagueBot> bots = bots();
        boolean adaptive = root.has(PAIRING) && root.isText(PAIRING) && root.text(PAIRING).equals(ADAPTIVE);
        String gauntlet = adaptive ? null : gauntlet(bots);
        Block replays = root.optionalBlock("replays").orElse(null);
        KeptReplays keep = replays == null ? KeptReplays.FAILED
            : replays.choice(KEEP, words(KeptReplays.values(), KeptReplays::word), KeptReplays.FAILED);
        List<String> losers = replays == null || !replays.has("of") ? List.of() : texts(replays, "of");
        for (String loser : losers) {
            if (keep != KeptReplays.LOST) {
                throw replays.error("of", "a list", "none: it is for \"keep\": \"lost\"");
            }
            known(replays, "of", loser, bots);
        }
        LeagueSettings settings = new LeagueSettings(scene, seed, seedFile, gauntlet, adaptive, lag, factor(time),
            basis(time), hiccups, sandbox, keep, losers, bots);
        root.done();
        return settings;
    }

    private static <E> Map<String, E> words(E[] values, Function<E, String> word) {
        Map<String, E> words = new LinkedHashMap<>();
        for (E value : values) {
            words.put(word.apply(value), value);
        }
        return words;
    }

    private long seed() {
        String text = root.text(SEED);
        try {
            return Long.parseLong(text);
        } catch (NumberFormatException problem) {
            throw root.error(SEED, root.shown(SEED), "a whole number of 64 bits as a text, such as \"7\"");
        }
    }

    private String seedFile() {
        String file = root.text(SEEDS);
        if (!FILE_NAME.matcher(file).matches()) {
            throw root.error(SEEDS, root.shown(SEEDS), "the name of a file in the league's folder, such as \""
                + LeagueFolder.SEEDS + "\"");
        }
        return file;
    }

    private static double factor(Block time) {
        if (time == null || !time.has(FACTOR)) {
            return 1;
        }
        if (time.isText(FACTOR) && time.text(FACTOR).equals("none")) {
            return Double.POSITIVE_INFINITY;
        }
        if (time.isText(FACTOR)) {
            throw time.error(FACTOR, time.shown(FACTOR), "a number above 0, or \"none\" for no limits");
        }
        double factor = time.positive(FACTOR);
        if (factor > MOST_FACTOR) {
            throw time.error(FACTOR, time.shown(FACTOR), "at most " + (long) MOST_FACTOR);
        }
        return factor;
    }

    private static TimeBasis basis(Block time) {
        TimeBasis basis = time == null ? TimeBasis.WALL
            : time.choice("basis", words(TimeBasis.CHOICES.toArray(TimeBasis[]::new), TimeBasis::word), TimeBasis.WALL);
        if (basis == TimeBasis.CPU && factor(time) == Double.POSITIVE_INFINITY) {
            throw time.error("basis", "\"cpu\" without limits", "\"wall\"");
        }
        return basis;
    }

    /** The options of a match that say the same. */
    private static List<String> sandbox(Block block) {
        List<String> words = new ArrayList<>();
        for (String[] each : new String[][] {{"level", "--sandbox"}, {"memory", "--memory"},
            {"fileSize", "--file-size"}}) {
            if (block.has(each[0])) {
                words.addAll(List.of(each[1], block.text(each[0])));
            }
        }
        for (String[] each : new String[][] {{"processes", "--processes"}, {"openFiles", "--open-files"}}) {
            if (block.has(each[0])) {
                words.addAll(List.of(each[1], Integer.toString(block.integer(each[0], 1, Integer.MAX_VALUE))));
            }
        }
        for (String[] each : new String[][] {{"network", "--network"}, {"cleanEnvironment", "--clean-env"}}) {
            if (block.flag(each[0], false)) {
                words.add(each[1]);
            }
        }
        if (block.has(PAUSE)) {
            throw block.error(PAUSE, block.shown(PAUSE), "\"hold\": \"always\" in its place, as Steward 0.2.0 writes "
                + "it");
        }
        if (block.has(HOLD)) {
            words.addAll(List.of(LeagueSettings.HOLD, block.choice(HOLD, words(HoldPolicy.values(), HoldPolicy::word),
                HoldPolicy.BURNERS).word()));
        }
        for (String[] each : new String[][] {{"environment", "--env"}, {"visible", "--visible"}}) {
            if (block.has(each[0])) {
                texts(block, each[0]).forEach(text -> words.addAll(List.of(each[1], text)));
            }
        }
        return words;
    }

    private static List<String> texts(Block block, String name) {
        Entry entry = block.entries().get(name);
        if (!(entry.value() instanceof JsonArray array)) {
            throw block.error(name, block.shown(name), "an array of texts");
        }
        List<String> texts = new ArrayList<>();
        array.values().forEach(value -> {
            if (!(value instanceof JsonText text) || text.text().isBlank()) {
                throw block.error(name, value.shown() + " among its elements", "texts");
            }
            texts.add(text.text());
        });
        return texts;
    }

    private List<LeagueBot> bots() {
        List<LeagueBot> bots = new ArrayList<>();
        Set<String> names = new HashSet<>();
        for (Block block : root.has(BOTS) ? root.blocks(BOTS) : List.<Block>of()) {
            String name = block.text(NAME_FIELD);
            if (!isName(name)) {
                throw block.error(NAME_FIELD, block.shown(NAME_FIELD), name.indexOf(LeagueBot.AT) < 0 ? NAME_FORM
                    : "NAME@PLATFORM with " + Platform.FORM);
            }
            if (!names.add(name)) {
                throw block.error(NAME_FIELD, block.shown(NAME_FIELD) + " a second time", "each name once");
            }
            LeagueBot bot = new LeagueBot(name, block.text("command"),
                folder(block), block.has("files") ? texts(block, "files") : null, block.flag("random", false),
                block.flag("retired", false), block.integer("resumed", 0, Integer.MAX_VALUE, 0),
                block.has(PLATFORMS) ? platforms(block, name) : List.of(), limits(block));
            parse(block, bot);
            bots.add(bot);
        }
        return bots;
    }

    /** True if this is a bot's name, with or without a platform. */
    public static boolean isName(String name) {
        int at = name.indexOf(LeagueBot.AT);
        return NAME.matcher(at < 0 ? name : name.substring(0, at)).matches()
            && (at < 0 || Platform.isWritten(name.substring(at + 1)));
    }

    private static String folder(Block block) {
        String folder = block.has(FOLDER) ? block.text(FOLDER) : null;
        if (folder != null && (folder.isBlank() || folder.indexOf('\0') >= 0)) {
            throw block.error(FOLDER, block.shown(FOLDER), "the path of a folder");
        }
        return folder;
    }

    private static OwnLimits limits(Block block) {
        if (!block.has(ANSWER)) {
            if (block.has(FIRST_ANSWER)) {
                throw block.error(FIRST_ANSWER, block.shown(FIRST_ANSWER), "\"" + ANSWER + "\" beside it");
            }
            return null;
        }
        return new OwnLimits(block.integer(ANSWER, 1, OwnLimits.MOST_MS),
            block.has(FIRST_ANSWER) ? block.integer(FIRST_ANSWER, 1, OwnLimits.MOST_MS) : 0);
    }

    private static void parse(Block block, LeagueBot bot) {
        try {
            bot.parsed();
        } catch (IllegalArgumentException problem) {
            throw block.error("command", problem.getMessage(), "a program and its arguments");
        }
    }

    /** Commands of a bot that are for one platform each. */
    private static List<LeagueBot.ForPlatform> platforms(Block bot, String name) {
        List<LeagueBot.ForPlatform> platforms = new ArrayList<>();
        for (Block block : bot.blocks(PLATFORMS)) {
            String platform = block.text(PLATFORM);
            if (!Platform.isWritten(platform)) {
                throw block.error(PLATFORM, block.shown(PLATFORM), Platform.FORM);
            }
            if (name.indexOf(LeagueBot.AT) >= 0) {
                throw block.error(PLATFORM, block.shown(PLATFORM), "none: the bot plays on the platform of its name");
            }
            if (platforms.stream().anyMatch(other -> other.platform().equals(platform))) {
                throw block.error(PLATFORM, block.shown(PLATFORM) + " a second time", "each platform once");
            }
            LeagueBot.ForPlatform one = new LeagueBot.ForPlatform(platform, block.text("command"),
                folder(block), block.has("files") ? texts(block, "files") : null);
            parse(block, new LeagueBot(name, one.command(), one.files(), false, false));
            platforms.add(one);
        }
        return platforms;
    }

    private String gauntlet(List<LeagueBot> bots) {
        String pairing = root.has(PAIRING) ? root.text(PAIRING) : ROUND_ROBIN;
        if (pairing.equals(ROUND_ROBIN)) {
            return null;
        }
        if (!pairing.startsWith(GAUNTLET)) {
            throw root.error(PAIRING, root.shown(PAIRING), "\"adaptive\", \"round-robin\" or \"gauntlet NAME\"");
        }
        String hero = pairing.substring(GAUNTLET.length()).strip();
        known(root, PAIRING, hero, bots);
        return hero;
    }

    private static void known(Block block, String field, String name, List<LeagueBot> bots) {
        List<String> names = bots.stream().map(LeagueBot::name).toList();
        if (!names.contains(name)) {
            throw block.error(field, "the unknown bot \"" + name + "\"", "one of the league's bots"
                + NearestName.question(name, names, "\""));
        }
    }
}
