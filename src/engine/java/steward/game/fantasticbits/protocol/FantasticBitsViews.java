package steward.game.fantasticbits.protocol;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import steward.game.Game;
import steward.game.ShownMessages;
import steward.game.ViewWriter;
import steward.game.fantasticbits.EntityKind;
import steward.game.fantasticbits.FantasticBits;
import steward.game.fantasticbits.Pitch;
import steward.game.fantasticbits.Spell;
import steward.game.fantasticbits.WizardCommand;
import steward.physics.Bodies;
import steward.physics.TeeSink;
import steward.scene.Scene;

/**
 * Writer of views of Fantastic Bits in the form of the published referee:
 * <pre>
 * line 0      the number of the frame
 * frame 0     Fantastic Bits
 *             width height wizardRadius wizards snaffleRadius goalSize
 *             player x y of each wizard; id x y of each snaffle; of each bludger          a line each
 * then        a line for each wizard, x y vx vy power targetX targetY message
 *             how many spells are at work, and a line for each
 *             how many snaffles there are, and id x y inPlay of each; how many bludgers, and id x y of each
 *             a score per player; the magic of each; then what has met, in order
 * </pre>
 * Which variant was played the server does not tell: today's is taken.
 */
final class FantasticBitsViews implements ViewWriter {

    static final String TITLE = "Fantastic Bits";

    private static final List<Spell> ORDER = List.of(Spell.ACCIO, Spell.FLIPENDO, Spell.OBLIVIATE, Spell.PETRIFICUS);
    private static final int LONGEST_MESSAGE = 28;
    private static final int KEPT = 26;
    private static final int GOAL_SIZE = (int) (Pitch.MOUTH_BOTTOM - Pitch.MOUTH_TOP);

    private FantasticBits game;
    private MeetingLines meetings;
    private final WizardCommand[] commands = new WizardCommand[Pitch.WIZARDS];
    private final int[] castAt = {-1, -1, -1, -1};
    private final boolean[] spellFailed = new boolean[Pitch.WIZARDS];

    @Override
    public List<String> notCompared() {
        return List.of("gameInformation, tooltips, texts in colour", "numbers of what has met",
            "of a turn in which a player fails messages, summary and the word behind the number");
    }

    @Override
    public Scene observed(Scene scene) {
        return scene.withObserver((parts, advance) -> (bodies, sink) -> {
            meetings = new MeetingLines(bodies);
            advance.turn(bodies, new TeeSink(sink, meetings));
        });
    }

    @Override
    public void begin(Game of) {
        game = (FantasticBits) of;
    }

    @Override
    public Frame start() {
        Bodies bodies = game.bodies();
        int snaffles = game.pitch().snaffles();
        List<String> view = new ArrayList<>(List.of(ANY, TITLE, (int) Pitch.WIDTH + " "
            + (int) Pitch.HEIGHT + " " + (int) EntityKind.WIZARD.radius() + " " + Pitch.WIZARDS + " "
            + (int) EntityKind.SNAFFLE.radius() + " " + GOAL_SIZE));
        view.add(IntStream.range(0, Pitch.WIZARDS).mapToObj(wizard -> Pitch.playerOf(wizard) + place(wizard))
            .collect(Collectors.joining(" ")));
        for (int first : new int[] {Pitch.WIZARDS, Pitch.WIZARDS + snaffles}) {
            int end = first == Pitch.WIZARDS ? Pitch.WIZARDS + snaffles : game.pitch().entities();
            view.add(IntStream.range(first, end).mapToObj(k -> bodies.id(k) + place(k))
                .collect(Collectors.joining(" ")));
        }
        for (int wizard = 0; wizard < Pitch.WIZARDS; wizard++) {
            view.add((place(wizard) + speed(wizard)).strip() + " 0 " + (int) (Pitch.WIDTH / 2) + " "
                + (int) (Pitch.HEIGHT / 2));
        }
        addRest(view);
        return new Frame(view, summary());
    }

    @Override
    public void before() {
        for (int player = 0; player < game.players(); player++) {
            int magic = game.magic(player);
            for (int k = 0; k < Pitch.WIZARDS_PER_PLAYER; k++) {
                int wizard = player * Pitch.WIZARDS_PER_PLAYER + k;
                WizardCommand command = game.command(player, k);
                commands[wizard] = command;
                spellFailed[wizard] = false;
                if (command != null && command.action() == WizardCommand.Action.CAST) {
                    int cost = game.settings().variant().cost(command.spell());
                    castAt[wizard] = command.target();
                    spellFailed[wizard] = magic < cost;
                    magic -= magic < cost ? 0 : cost;
                }
            }
        }
    }

    @Override
    public Frame after(String[] messages, List<String> shown) {
        boolean failed = !game.isIn(0) || !game.isIn(1);
        boolean rounds = game.turn() >= game.settings().maximumTurns() && game.ending() != null
            && game.ending().startsWith("at most");
        List<String> view = new ArrayList<>(List.of(ANY + " " + (failed ? REST : !game.isOver() ? ""
            : rounds ? "maxRoundsCountReached" : "endReached")));
        for (int player = 0; player < game.players(); player++) {
            ShownMessages said = new ShownMessages(messages[player], LONGEST_MESSAGE, KEPT, "...");
            for (int k = 0; k < Pitch.WIZARDS_PER_PLAYER; k++) {
                int wizard = player * Pitch.WIZARDS_PER_PLAYER + k;
                String[] words = wizard + 1 < shown.size() ? shown.get(wizard + 1).strip().split("\\s+", 8)
                    : new String[0];
                String message = said.next(words.length < 8 ? "" : words[7], k == Pitch.WIZARDS_PER_PLAYER - 1);
                view.add((place(wizard) + speed(wizard)).strip() + " " + aim(wizard) + " "
                    + (game.isIn(player) ? message : REST));
            }
        }
        addRest(view);
        if (meetings != null) {
            view.addAll(meetings.lines());
        }
        List<String> summary = failed ? new ArrayList<>() : summary();
        if (game.isOver()) {
            summary.add(REST);
        }
        return new Frame(view, summary);
    }

    private String place(int entity) {
        return " " + (long) game.bodies().x[entity] + " " + (long) game.bodies().y[entity];
    }

    private String speed(int wizard) {
        return " " + (long) game.bodies().vx[wizard] + " " + (long) game.bodies().vy[wizard];
    }

    /** Power and target of a wizard; without a place, its last spell's target, where that is after the turn. */
    private String aim(int wizard) {
        WizardCommand command = commands[wizard];
        if (command != null && command.action() != WizardCommand.Action.CAST) {
            return (command.action() == WizardCommand.Action.MOVE ? (long) command.power() : 0) + " "
                + (long) command.x() + " " + (long) command.y();
        }
        int target = castAt[wizard] < 0 ? -1 : game.bodies().indexOf(castAt[wizard]);
        return "0" + (target < 0 ? " null null" : place(target));
    }

    private void addRest(List<String> view) {
        List<String> spells = new ArrayList<>();
        for (int wizard = 0; wizard < Pitch.WIZARDS; wizard++) {
            for (Spell spell : ORDER) {
                int turns = game.pitch().spells().turns(wizard, spell);
                if (turns > 0) {
                    spells.add(spell.text().toUpperCase(Locale.ROOT) + " " + wizard + " "
                        + game.pitch().spells().target(wizard, spell) + " " + turns + " "
                        + (turns == game.settings().variant().turns(spell)));
                }
            }
        }
        view.add(Integer.toString(spells.size()));
        view.addAll(spells);
        int snaffles = game.pitch().snaffles();
        view.add(Integer.toString(snaffles));
        for (int k = Pitch.WIZARDS; k < game.pitch().entities(); k++) {
            if (k == Pitch.WIZARDS + snaffles) {
                view.add(Integer.toString(Pitch.BLUDGERS));
            }
            view.add(game.bodies().id(k) + place(k) + (k >= Pitch.WIZARDS + snaffles ? ""
                : game.pitch().kind(k) == EntityKind.LOST_SNAFFLE ? " 0" : " 1"));
        }
        view.add(game.score(0) + " " + game.score(1));
        view.add(game.magic(0) + " " + game.magic(1));
    }

    private List<String> summary() {
        List<String> lines = new ArrayList<>();
        for (int player = 0; player < game.players(); player++) {
            lines.add("$" + player + " Score: " + game.score(player) + " | Magic: " + game.magic(player));
            for (int k = 0; k < Pitch.WIZARDS_PER_PLAYER; k++) {
                int wizard = player * Pitch.WIZARDS_PER_PLAYER + k;
                if (game.pitch().held(wizard) >= 0) {
                    lines.add("$" + player + " " + wizard + " caught snaffle " + game.pitch().held(wizard));
                }
                if (spellFailed[wizard]) {
                    lines.add("$" + player + ": Wizard " + wizard + " failed his spell!");
                }
            }
        }
        return lines;
    }
}
