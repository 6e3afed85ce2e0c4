package steward.game.fantasticbits.protocol;

import java.util.List;
import steward.game.CommandsJson;
import steward.game.fantasticbits.Captures;
import steward.game.fantasticbits.EntityKind;
import steward.game.fantasticbits.FantasticBits;
import steward.game.fantasticbits.Pitch;
import steward.game.fantasticbits.Spell;
import steward.game.fantasticbits.SpellBook;
import steward.game.fantasticbits.Variant;
import steward.game.fantasticbits.WizardCommand;
import steward.json.DrawingJson;
import steward.json.JsonNumbers;
import steward.json.JsonObject;
import steward.json.WallJson;
import steward.physics.Bodies;
import steward.physics.Segment;
import steward.physics.Wall;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.io.SerializedString;

/**
 * JSON of Fantastic Bits: frames, commands, states and drawing; {@link FantasticBitsAnswer} reads answers. A recorded
 * command that the state does not allow, since another bot has changed the course of the match, is read and does
 * nothing.
 */
public final class FantasticBitsJson extends CommandsJson<WizardCommand> {

    /** Around the pitch, so that the goals are seen. */
    private static final double MARGIN = 500;
    /** The kinds that move; the last one is not in all leagues. */
    private static final List<EntityKind> KINDS = List.of(EntityKind.WIZARD, EntityKind.SNAFFLE, EntityKind.BLUDGER);
    private static final List<Wall> WALLS = List.of(
        wall(0, 0, Pitch.WIDTH, 0), wall(0, Pitch.HEIGHT, Pitch.WIDTH, Pitch.HEIGHT),
        wall(0, 0, 0, Pitch.MOUTH_TOP), wall(0, Pitch.MOUTH_BOTTOM, 0, Pitch.HEIGHT),
        wall(Pitch.WIDTH, 0, Pitch.WIDTH, Pitch.MOUTH_TOP),
        wall(Pitch.WIDTH, Pitch.MOUTH_BOTTOM, Pitch.WIDTH, Pitch.HEIGHT));
    private static final SerializedString ID = new SerializedString("id");
    private static final SerializedString KIND = new SerializedString("kind");
    private static final SerializedString PLAYER = new SerializedString("player");
    private static final SerializedString SNAFFLE = new SerializedString("snaffle");
    private static final SerializedString WAIT = new SerializedString("captureWait");
    private static final SerializedString SPELLS = new SerializedString("spells");
    private static final SerializedString CAST = new SerializedString("cast");
    private static final SerializedString HELD = new SerializedString("held");
    private static final SerializedString IGNORED = new SerializedString("ignored");
    private static final SerializedString VICTIM = new SerializedString("lastVictim");
    private static final SerializedString SPELL = new SerializedString("spell");
    private static final SerializedString TURNS = new SerializedString("turns");
    private static final SerializedString TARGET = new SerializedString("target");

    private final FantasticBits game;
    private final Pitch pitch;

    FantasticBitsJson(FantasticBits game) {
        super(game.players(), new FantasticBitsAnswer(game), new FantasticBitsAnswer(null));
        this.game = game;
        pitch = game.pitch();
    }

    /** State of a game. @param bodies wizards, snaffles in play and bludgers */
    public record State(List<Entity> bodies, List<Entity> outOfPlay, int[] scores, int[] magic) { }

    /** An entity; a component that its kind does not have is {@code null}. */
    public record Entity(int id, String kind, Integer player, double x, double y, double vx, double vy,
                         Integer snaffle, Integer captureWait, List<SpellAtWork> spells, SpellAtWork cast,
                         Integer lastVictim, Boolean held, int[] ignored) { }

    /** A spell and the id of its target. @param turns that it still works; {@code null} before it begins */
    public record SpellAtWork(String spell, Integer turns, int target) { }

    private static Wall wall(double ax, double ay, double bx, double by) {
        return new Segment(ax, ay, bx, by, 1);
    }

    @Override
    public void writeSetup(JsonGenerator out, int player) {
        Variant variant = game.settings().variant();
        out.writeStringProperty("variant", variant.text());
        JsonNumbers.write(out, "width", Pitch.WIDTH);
        JsonNumbers.write(out, "height", Pitch.HEIGHT);
        out.writeObjectPropertyStart("goal");
        JsonNumbers.write(out, "x", player == 0 ? Pitch.WIDTH : 0);
        JsonNumbers.write(out, "top", Pitch.MOUTH_TOP);
        JsonNumbers.write(out, "bottom", Pitch.MOUTH_BOTTOM);
        out.writeEndObject();
        JsonObject.writeEach(out, "posts", Pitch.POSTS, post -> DrawingJson.place(out, post.x(), post.y()));
        JsonObject.writeAll(out, "kinds", game.settings().bludgers() ? KINDS : KINDS.subList(0, 2), kind -> {
            out.writeStringProperty("kind", kind.text());
            JsonNumbers.write(out, "radius", kind.radius());
            JsonNumbers.write(out, "mass", kind.mass());
            JsonNumbers.write(out, "friction", kind.friction());
        });
        JsonNumbers.write(out, "postRadius", EntityKind.POST.radius());
        JsonNumbers.write(out, "captureReach", Captures.REACH);
        out.writeNumberProperty("maximumPower", WizardCommand.MOST_THRUST);
        out.writeNumberProperty("maximumThrow", WizardCommand.MOST_THROW);
        out.writeNumberProperty("maximumMagic", FantasticBits.MOST_MAGIC);
        JsonObject.writeAll(out, "spells", game.settings().spells() ? Spell.count() : 0, k -> {
            Spell spell = Spell.of(k);
            out.writeStringProperty("spell", spell.text());
            out.writeNumberProperty("cost", variant.cost(spell));
            out.writeNumberProperty("turns", variant.turns(spell));
        });
        out.writeNumberProperty("winningScore", game.winningScore());
        out.writeNumberProperty("maximumTurns", game.settings().maximumTurns());
    }

    @Override
    public void writeTurn(JsonGenerator out, int player) {
        writePlayers(out);
        writeEntities(out, "entities", false, false);
    }

    private void writePlayers(JsonGenerator out) {
        JsonNumbers.writeAll(out, "scores", game.players(), game::score);
        JsonNumbers.writeAll(out, "magic", game.players(), game::magic);
    }

    private void writeEntities(JsonGenerator out, String name, boolean lost, boolean whole) {
        out.writeArrayPropertyStart(name);
        for (int k = 0; k < pitch.entities(); k++) {
            if (pitch.kind(k) == EntityKind.LOST_SNAFFLE == lost) {
                out.writeStartObject();
                writeEntity(out, k, whole);
                out.writeEndObject();
            }
        }
        out.writeEndArray();
    }

    /** @param whole with what bots do not see: the snaffles that one has yet to leave */
    private void writeEntity(JsonGenerator out, int entity, boolean whole) {
        Bodies bodies = pitch.bodies();
        EntityKind kind = pitch.kind(entity);
        JsonNumbers.write(out, ID, bodies.id(entity));
        out.writeName(KIND);
        out.writeString(kind.text());
        if (kind == EntityKind.WIZARD) {
            JsonNumbers.write(out, PLAYER, Pitch.playerOf(entity));
        }
        DrawingJson.flight(out, bodies, entity);
        if (kind == EntityKind.WIZARD) {
            JsonNumbers.write(out, SNAFFLE, pitch.held(entity));
            JsonNumbers.write(out, WAIT, (int) bodies.columns[Pitch.WAIT][entity]);
            writeSpells(out, entity);
        } else if (kind == EntityKind.BLUDGER) {
            JsonNumbers.write(out, VICTIM, (int) bodies.columns[Pitch.LAST_VICTIM][entity]);
        } else {
            if (kind != EntityKind.LOST_SNAFFLE) {
                JsonNumbers.write(out, HELD, kind == EntityKind.HELD_SNAFFLE);
            }
            if (whole) {
                writeIgnored(out, entity);
            }
        }
    }

    private void writeIgnored(JsonGenerator out, int snaffle) {
        out.writeName(IGNORED);
        out.writeStartArray();
        for (int other = Pitch.WIZARDS; other < Pitch.WIZARDS + pitch.snaffles(); other++) {
            if (Pitch.ignores(pitch.bodies(), snaffle, other)) {
                out.writeNumber(other);
            }
        }
        out.writeEndArray();
    }

    /** The spells at work, and the one that begins with the next turn. */
    private void writeSpells(JsonGenerator out, int wizard) {
        SpellBook spells = pitch.spells();
        out.writeName(SPELLS);
        out.writeStartArray();
        for (int k = 0; k < Spell.count(); k++) {
            Spell spell = Spell.of(k);
            if (spells.turns(wizard, spell) > 0) {
                writeSpell(out, spell, spells.turns(wizard, spell), spells.target(wizard, spell));
            }
        }
        out.writeEndArray();
        if (spells.cast(wizard) != null) {
            out.writeName(CAST);
            writeSpell(out, spells.cast(wizard), 0, spells.castAt(wizard));
        }
    }

    private static void writeSpell(JsonGenerator out, Spell spell, int turns, int target) {
        out.writeStartObject();
        out.writeName(SPELL);
        out.writeString(spell.text());
        if (turns > 0) {
            JsonNumbers.write(out, TURNS, turns);
        }
        JsonNumbers.write(out, TARGET, target);
        out.writeEndObject();
    }

    @Override
    public void writeState(JsonGenerator out) {
        writeEntities(out, "bodies", false, true);
        writeEntities(out, "outOfPlay", true, true);
        writePlayers(out);
    }

    @Override
    public void writeProgress(JsonGenerator out) {
        JsonNumbers.writeAll(out, "scores", game.players(), game::score);
        JsonObject.writeAll(out, "resources", game.players(),
            player -> out.writeNumberProperty("magic", game.magic(player)));
    }

    /** The pitch, its walls with the goals left open, and the entities. */
    @Override
    public void writeDrawing(JsonGenerator out) {
        DrawingJson.field(out, -MARGIN, -MARGIN, Pitch.WIDTH + 2 * MARGIN, Pitch.HEIGHT + 2 * MARGIN);
        WallJson.write(out, WALLS);
        Bodies bodies = game.bodies();
        JsonObject.writeEach(out, "bodies", bodies.size(), k -> {
            EntityKind kind = pitch.kind(k);
            switch (kind) {
                case POST -> DrawingJson.fixedBody(out, bodies, k, kind.text());
                case WIZARD -> DrawingJson.body(out, bodies.id(k), kind.text(), bodies.radius[k], Pitch.playerOf(k),
                    Integer.toString(k));
                default -> DrawingJson.freeBody(out, bodies.id(k), kind.text(), bodies.radius[k]);
            }
        });
    }

    @Override
    protected int commands(int player) {
        return Pitch.WIZARDS_PER_PLAYER;
    }

    @Override
    protected WizardCommand command(int player, int wizard) {
        return game.command(player, wizard);
    }

    @Override
    protected void command(int player, int wizard, WizardCommand command) {
        game.command(player, wizard, command);
    }

    @Override
    protected void writeFields(JsonGenerator out, WizardCommand command) {
        FantasticBitsAnswer.write(out, command);
    }
}
