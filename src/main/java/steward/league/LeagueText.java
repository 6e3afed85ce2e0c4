package steward.league;

import java.util.ArrayList;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import steward.bot.TimeBasis;
import steward.match.OwnLimits;
import steward.scene.json.Wording;
import tools.jackson.databind.json.JsonMapper;

/** Text of league.json as a person would write it: one field a line, one bot a line. */
final class LeagueText {

    private static final Map<String, String> TEXTS = Map.of("--sandbox", "level", "--memory", "memory", "--file-size",
        "fileSize", LeagueSettings.HOLD, "hold");
    private static final Map<String, String> NUMBERS = Map.of("--processes", "processes", "--open-files", "openFiles");
    private static final Map<String, String> FLAGS = Map.of("--network", "network", "--clean-env", "cleanEnvironment");
    private static final Map<String, String> LISTS = Map.of("--env", "environment", "--visible", "visible");

    static String write(LeagueSettings settings) {
        List<String> fields = new ArrayList<>();
        fields.add(field("league", Integer.toString(LeagueReader.FORM)));
        fields.add(field("scene", text(settings.scene())));
        fields.add(field("seed", text(Long.toString(settings.seed()))));
        if (settings.seedFile() != null) {
            fields.add(field(LeagueReader.SEEDS, text(settings.seedFile())));
        }
        fields.add(field("pairing", text(settings.pairing())));
        fields.add(field("lag", Integer.toString(settings.lag())));
        fields.add(field("time", time(settings)));
        fields.add(field("hiccups", text(settings.hiccups().word())));
        fields.add(field("sandbox", sandbox(settings.sandbox())));
        fields.add(field("replays", "{ " + field("keep", text(settings.keep().word()))
            + (settings.keepOf().isEmpty() ? "" : ", " + field("of", list(settings.keepOf()))) + " }"));
        fields.add(field("bots", "["
            + String.join(",", settings.bots().stream().map(bot -> "\n    " + bot(bot)).toList())
            + (settings.bots().isEmpty() ? "]" : "\n  ]")));
        return "{\n  " + String.join(",\n  ", fields) + "\n}\n";
    }

    private static String time(LeagueSettings settings) {
        String factor = settings.factor() == Double.POSITIVE_INFINITY ? text("none")
            : Wording.number(settings.factor());
        return "{ " + field("factor", factor) + (settings.basis() == TimeBasis.WALL ? ""
            : ", " + field("basis", text(settings.basis().word()))) + " }";
    }

    private static String bot(LeagueBot bot) {
        return "{ " + field("name", text(bot.name())) + ", " + field("command", text(bot.command()))
            + (bot.folder() == null ? "" : ", " + field("folder", text(bot.folder())))
            + (bot.files() == null ? "" : ", " + field("files", list(bot.files())))
            + (bot.limits() == null ? "" : ", " + limits(bot.limits()))
            + (bot.random() ? ", " + field("random", "true") : "")
            + (bot.retired() ? ", " + field("retired", "true") : "")
            + (bot.resumed() > 0 ? ", " + field("resumed", Integer.toString(bot.resumed())) : "")
            + (bot.platforms().isEmpty() ? "" : ", " + field("platforms", "[" + String.join(", ",
                bot.platforms().stream().map(LeagueText::forPlatform).toList()) + "]")) + " }";
    }

    private static String limits(OwnLimits limits) {
        return field(LeagueReader.ANSWER, Integer.toString(limits.answerMs())) + (limits.firstAnswerMs() == 0 ? ""
            : ", " + field(LeagueReader.FIRST_ANSWER, Integer.toString(limits.firstAnswerMs())));
    }

    private static String forPlatform(LeagueBot.ForPlatform one) {
        return "{ " + field("platform", text(one.platform())) + ", " + field("command", text(one.command()))
            + (one.folder() == null ? "" : ", " + field("folder", text(one.folder())))
            + (one.files() == null ? "" : ", " + field("files", list(one.files()))) + " }";
    }

    private static String sandbox(List<String> words) {
        List<String> fields = new ArrayList<>();
        Map<String, List<String>> lists = new LinkedHashMap<>();
        for (Iterator<String> word = words.iterator(); word.hasNext();) {
            String option = word.next();
            if (FLAGS.containsKey(option)) {
                fields.add(field(FLAGS.get(option), "true"));
            } else if (TEXTS.containsKey(option)) {
                fields.add(field(TEXTS.get(option), text(word.next())));
            } else if (NUMBERS.containsKey(option)) {
                fields.add(field(NUMBERS.get(option), word.next()));
            } else {
                lists.computeIfAbsent(LISTS.get(option), name -> new ArrayList<>()).add(word.next());
            }
        }
        lists.forEach((name, values) -> fields.add(field(name, list(values))));
        return fields.isEmpty() ? "{ \"level\": \"auto\" }" : "{ " + String.join(", ", fields) + " }";
    }

    private static String field(String name, String value) {
        return text(name) + ": " + value;
    }

    private static String list(List<String> values) {
        return "[" + String.join(", ", values.stream().map(LeagueText::text).toList()) + "]";
    }

    private static String text(String value) {
        return JsonMapper.shared().writeValueAsString(value);
    }
}
