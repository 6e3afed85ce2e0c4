package steward.game.meanmax.protocol;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import steward.game.ServerView;
import steward.game.ShownSeed;
import steward.game.meanmax.MeanMaxSettings;
import steward.game.meanmax.Skill;
import steward.game.meanmax.UnitKind;
import steward.scene.SceneFiles;
import steward.text.ViewLines;
import tools.jackson.core.JsonGenerator;

/**
 * A game of Mean Max as the views of the server show it:
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
final class MeanMaxShown implements ServerView.Shown {

    private static final String SCENE = "mean-max";
    private static final int PLAYERS_LINE = 2;
    private static final int FIRST_SCORE_OF_START = 6;
    private static final int FIRST_SCORE = 1;
    private static final int PLAYERS = MeanMaxSettings.PLAYERS;
    private static final int MESSAGES = PLAYERS * UnitKind.LOOTERS;
    private static final int WRECK_TYPE = 4;
    private static final int UNIT_WORDS = 5;
    private static final int MOST = 1_000_000;
    private static final String END = "#1.00000";

    private final long seed;
    private final ShownTurn start;
    private final List<ShownTurn> turns = new ArrayList<>();
    private final Map<Integer, ShownTurn.What> known = new TreeMap<>();
    private final Map<Integer, ShownTurn.Wreck> wrecks = new TreeMap<>();
    private final Map<Integer, ShownTurn.Effect> effects = new TreeMap<>();

    MeanMaxShown(ViewLines first, String input) {
        seed = ShownSeed.required(input, first.source());
        if (!first.line(PLAYERS_LINE).strip().equals(Integer.toString(PLAYERS))) {
            throw first.wrong(PLAYERS_LINE, PLAYERS + ", the number of players");
        }
        start = read(first, FIRST_SCORE_OF_START, new TreeMap<>());
    }

    @Override
    public String scene() {
        return SceneFiles.load(SCENE).text();
    }

    @Override
    public long seed() {
        return seed;
    }

    @Override
    public void add(ViewLines view) {
        Map<Integer, Integer> before = turns.isEmpty() || turns.get(turns.size() - 1) == null ? new TreeMap<>()
            : turns.get(turns.size() - 1).water();
        turns.add(view.count() == 0 ? null : read(view, FIRST_SCORE, before));
    }

    @Override
    public void writeStart(JsonGenerator out) {
        start.writeState(out, true);
    }

    @Override
    public void writeOutcome(JsonGenerator out, int turn) {
        if (turns.get(turn - 1) != null) {
            turns.get(turn - 1).writeOutcome(out);
        }
    }

    /** @param before takes the water of wrecks as it was before this turn */
    private ShownTurn read(ViewLines view, int firstScore, Map<Integer, Integer> before) {
        int[] scores = new int[PLAYERS];
        int[] rages = new int[PLAYERS];
        for (int player = 0; player < PLAYERS; player++) {
            scores[player] = single(view, firstScore + player, "the score of player " + player);
            rages[player] = single(view, firstScore + PLAYERS + player, "the rage of player " + player);
        }
        ShownTurn turn = new ShownTurn(new ArrayList<>(), new ArrayList<>(), new ArrayList<>(), new ArrayList<>(),
            new TreeMap<>(), new ArrayList<>(), scores, rages);
        int end = view.count() - 1;
        while (end > 0 && !view.line(end).startsWith("#")) {
            end--;
        }
        int line = firstScore + 2 * PLAYERS + MESSAGES;
        if (end < line || !view.line(end).strip().equals(END)) {
            throw view.wrong(Math.max(end, line), END + ", then all that is there after the turn");
        }
        while (line < end) {
            line = readMoment(view, line, end, turn);
        }
        for (line = end + 1; line < view.count(); line++) {
            readEnd(view, line, turn, before);
        }
        return turn;
    }

    private static int single(ViewLines view, int line, String expected) {
        String[] words = view.words(line);
        if (words.length != 1) {
            throw view.wrong(line, expected);
        }
        return view.whole(words[0], MOST, line);
    }

    /** Reads the impacts and deaths of one time. @return the line behind it */
    private int readMoment(ViewLines view, int from, int end, ShownTurn turn) {
        String text = view.line(from).strip();
        if (!text.startsWith("#")) {
            throw view.wrong(from, "#time of an impact");
        }
        double time = view.number(text.substring(1), from);
        if (time < 0 || time > 1) {
            throw view.wrongWord(text, from, "a time 0..1 within the turn");
        }
        List<ShownTurn.Unit> met = new ArrayList<>();
        int deaths = turn.deaths().size();
        int line = from + 1;
        for (; line < end && !view.line(line).startsWith("#"); line++) {
            String[] words = view.words(line);
            if (isWreck(words)) {
                addWreck(view, line, words);
            } else if (isGone(words)) {
                turn.deaths().add(new ShownTurn.Death(time, unit(view, line, words)));
            } else {
                met.add(unit(view, line, words));
            }
        }
        int sunk = turn.deaths().size() - deaths;
        if (met.size() + 2 * sunk < 1 || met.size() + 2 * sunk > 2) {
            throw view.wrong(from, "one unit that met the wall, two that met, or a tanker that was sunk");
        }
        if (sunk == 0) {
            turn.impacts().add(new ShownTurn.Impact(time, met.get(0), met.size() < 2 ? null : met.get(1)));
        }
        return line;
    }

    private void readEnd(ViewLines view, int line, ShownTurn turn, Map<Integer, Integer> before) {
        String[] words = view.words(line);
        if (words.length == 0) {
            return;
        }
        boolean tank = words[0].contains("@");
        if (isGone(words)) {
            remove(view, line, words, turn);
        } else if (words.length == 1 && tank) {
            int id = id(view, line, words);
            ShownTurn.Wreck wreck = wrecks.get(id);
            if (wreck == null) {
                throw view.wrong(line, "a wreck that was there before, or the line of its tanker");
            }
            before.put(id, water(view, line, words));
            turn.wrecks().add(wreck);
        } else if (words.length == 1) {
            ShownTurn.Effect effect = effects.get(id(view, line, words));
            if (effect == null) {
                throw view.wrong(line, "an effect that was there before, or id x y looter 0 type radius of a new one");
            }
            turn.effects().add(effect);
        } else if (words.length == 7 && !tank) {
            turn.effects().add(newEffect(view, line, words));
        } else {
            turn.units().add(unit(view, line, words));
        }
    }

    private void remove(ViewLines view, int line, String[] words, ShownTurn turn) {
        int id = id(view, line, words);
        boolean found;
        if (words.length > 2) {
            ShownTurn.Unit unit = unit(view, line, words);
            found = turn.units().removeIf(there -> there.id() == id);
            turn.deaths().add(new ShownTurn.Death(1, unit));
        } else if (words[0].contains("@")) {
            found = turn.wrecks().removeIf(wreck -> wreck.id() == id);
        } else {
            found = turn.effects().removeIf(effect -> effect.id() == id);
        }
        if (!found) {
            throw view.wrong(line, "something that was there in this turn");
        }
    }

    private static boolean isGone(String[] words) {
        return words.length > 1 && (words[words.length - 1].equals("d")
            || words.length > UNIT_WORDS && words[UNIT_WORDS].equals("d"));
    }

    private static boolean isWreck(String[] words) {
        return words.length == 7 && words[0].contains("@") && words[5].equals(Integer.toString(WRECK_TYPE));
    }

    private void addWreck(ViewLines view, int line, String[] words) {
        int id = id(view, line, words);
        wrecks.put(id, new ShownTurn.Wreck(id, view.whole(words[1], line), view.whole(words[2], line),
            view.number(words[6], line)));
    }

    private ShownTurn.Effect newEffect(ViewLines view, int line, String[] words) {
        int id = id(view, line, words);
        int type = view.whole(words[5], MOST, line);
        Skill skill = Arrays.stream(Skill.values()).filter(one -> one.type() == type).findFirst()
            .orElseThrow(() -> view.wrongWord(words[5], line, "the type of a skill 5..7"));
        ShownTurn.Effect effect = new ShownTurn.Effect(id, skill, view.whole(words[1], line),
            view.whole(words[2], line), view.whole(words[3], MESSAGES - 1, line));
        effects.put(id, effect);
        return effect;
    }

    /** A unit; what it is its first line tells. */
    private ShownTurn.Unit unit(ViewLines view, int line, String[] all) {
        String[] words = Arrays.stream(all).filter(word -> !word.equals("d")).toArray(String[]::new);
        if (words.length < UNIT_WORDS || words.length == 6 || words.length > 8) {
            throw view.wrong(line, "a unit: id x y vx vy, when it is new also kind radius player");
        }
        int id = id(view, line, words);
        boolean tanker = words[0].contains("@");
        if (words.length > UNIT_WORDS) {
            UnitKind kind = UnitKind.of(view.whole(words[5], UnitKind.values().length - 1, line));
            if ((kind == UnitKind.TANKER) != tanker || (words.length == 7) != tanker) {
                throw view.wrong(line, "id x y vx vy kind radius player of a looter, or id@water x y vx vy 3 radius");
            }
            known.put(id, new ShownTurn.What(kind, view.number(words[6], line),
                tanker ? -1 : view.whole(words[7], PLAYERS - 1, line)));
        }
        ShownTurn.What what = known.get(id);
        if (what == null) {
            throw view.wrong(line, "a unit that was there before, or with its kind and radius");
        }
        return new ShownTurn.Unit(id, what, view.whole(words[1], line), view.whole(words[2], line),
            view.whole(words[3], line), view.whole(words[4], line), tanker ? water(view, line, words) : 0);
    }

    private static int id(ViewLines view, int line, String[] words) {
        return view.whole(words[0].replaceFirst("@.*", ""), MOST, line);
    }

    private static int water(ViewLines view, int line, String[] words) {
        long water = view.whole(words[0].replaceFirst(".*@", ""), line);
        if (Math.abs(water) > MOST) {
            throw view.wrongWord(words[0], line, "id@water");
        }
        return (int) water;
    }
}
