package steward.cli.play;

import java.io.PrintStream;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import steward.cli.shared.FailureReason;
import steward.cli.streams.Colour;
import steward.contest.Contest;
import steward.contest.FailureKind;
import steward.report.Fields;
import steward.text.TextFormat;

/** Report on failures of bots in many games, for people and for programs. */
public final class FailureReport {

    /** Games that are named in a line at most. */
    static final int GAMES_SHOWN = 8;
    private static final int KINDS_SHOWN = 10;

    private FailureReport() { }

    /** The kinds with their first games, last lines of stderr and hints. */
    public static void print(PrintStream out, Colour colour, Contest contest, List<FailureKind> kinds) {
        List<List<FailureKind>> alike = alike(kinds);
        for (List<FailureKind> bots : alike.subList(0, Math.min(KINDS_SHOWN, alike.size()))) {
            FailureKind kind = bots.get(0);
            List<FailureKind.Occurrence> all = kind.occurrences();
            out.println();
            out.println(TextFormat.plain(bots.stream().map(bot -> contest.entrants().get(bot.entrant()).name())
                .collect(Collectors.joining(" and "))) + " "
                + colour.bad("failed") + TextFormat.plain(" in " + TextFormat.count(all.size(), "game")
                + (all.size() == 1 ? ", game " : ", first in game ") + kind.game().number() + " (seed "
                + kind.game().seed() + ") in turn " + kind.first().turn() + ": "
                + kind.first().reason()));
            FailureReason.print(out, kind.first(), "  ");
            if (kind.game().replay() != null) {
                out.println(TextFormat.plain("  replay: " + kind.game().replay()));
            }
            if (all.size() > 1) {
                out.println("  also in " + more(all.stream().skip(1).limit(GAMES_SHOWN).map(
                    one -> "game " + one.game().number() + ", turn " + one.turn()).toList(), all.size() - 1));
            }
        }
        if (alike.size() > KINDS_SHOWN) {
            out.println();
            out.println("and " + TextFormat.count(alike.size() - KINDS_SHOWN, "kind") + " of failure more; "
                + "--json lists all");
        }
    }

    /** Kinds about which the same would be said of several bots, together. */
    private static List<List<FailureKind>> alike(List<FailureKind> kinds) {
        Map<List<Object>, List<FailureKind>> alike = new LinkedHashMap<>();
        for (FailureKind kind : kinds) {
            alike.computeIfAbsent(List.of(kind.first().reason(), kind.first().stderr(), kind.first().hints(),
                kind.occurrences()), any -> new ArrayList<>()).add(kind);
        }
        return List.copyOf(alike.values());
    }

    static String more(List<String> shown, int all) {
        return String.join("; ", shown) + (all > shown.size() ? "; and " + (all - shown.size()) + " more" : "");
    }

    /** The field {@code failures}: an array with an object for each kind. */
    public static Iterable<Object> json(List<FailureKind> kinds) {
        return Fields.each(kinds, kind -> Fields.of("bot", kind.entrant(), "games", kind.occurrences().size(),
            "game", kind.game().number(), "seed", Long.toString(kind.game().seed()), "fault", kind.first().reason())
            .and(FailureReason.fields(kind.first())).with("replay", kind.game().replay()));
    }
}
