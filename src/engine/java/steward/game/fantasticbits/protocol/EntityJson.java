package steward.game.fantasticbits.protocol;

import steward.game.fantasticbits.EntityKind;
import steward.game.fantasticbits.FantasticBits;
import steward.game.fantasticbits.Pitch;
import steward.game.fantasticbits.Spell;
import steward.game.fantasticbits.SpellBook;
import steward.json.JsonNumbers;
import steward.physics.Bodies;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.SerializableString;
import tools.jackson.core.io.SerializedString;

/** Entities as JSON, the same in frames and states, but for what only the game needs to go on. */
final class EntityJson {

    /** The names that every turn writes, encoded once. */
    private static final class Name {
        static final SerializedString ID = new SerializedString("id");
        static final SerializedString KIND = new SerializedString("kind");
        static final SerializedString PLAYER = new SerializedString("player");
        static final SerializedString X = new SerializedString("x");
        static final SerializedString Y = new SerializedString("y");
        static final SerializedString VX = new SerializedString("vx");
        static final SerializedString VY = new SerializedString("vy");
        static final SerializedString SNAFFLE = new SerializedString("snaffle");
        static final SerializedString WAIT = new SerializedString("captureWait");
        static final SerializedString SPELLS = new SerializedString("spells");
        static final SerializedString SPELL = new SerializedString("spell");
        static final SerializedString TURNS = new SerializedString("turns");
        static final SerializedString TARGET = new SerializedString("target");
        static final SerializedString CAST = new SerializedString("cast");
        static final SerializedString HELD = new SerializedString("held");
        static final SerializedString IGNORED = new SerializedString("ignored");
        static final SerializedString VICTIM = new SerializedString("lastVictim");
        static final SerializedString LOST = new SerializedString("outOfPlay");
    }

    /**
     * Wizards, snaffles in play and bludgers.
     *
     * @param whole with what bots do not see, and then the snaffles that are out of play
     */
    static void write(JsonGenerator out, SerializableString name, FantasticBits game, boolean whole) {
        out.writeName(name);
        out.writeStartArray();
        writeKinds(out, game, whole, false);
        out.writeEndArray();
        if (whole) {
            out.writeName(Name.LOST);
            out.writeStartArray();
            writeKinds(out, game, true, true);
            out.writeEndArray();
        }
    }

    private static void writeKinds(JsonGenerator out, FantasticBits game, boolean whole, boolean lost) {
        Pitch pitch = game.pitch();
        for (int k = 0; k < pitch.entities(); k++) {
            if (pitch.kind(k) == EntityKind.LOST_SNAFFLE == lost) {
                out.writeStartObject();
                writeEntity(out, pitch, k, whole);
                out.writeEndObject();
            }
        }
    }

    private static void writeEntity(JsonGenerator out, Pitch pitch, int entity, boolean whole) {
        Bodies bodies = pitch.bodies();
        EntityKind kind = pitch.kind(entity);
        JsonNumbers.write(out, Name.ID, bodies.id(entity));
        out.writeName(Name.KIND);
        out.writeString(kind.text());
        if (kind == EntityKind.WIZARD) {
            JsonNumbers.write(out, Name.PLAYER, Pitch.playerOf(entity));
        }
        JsonNumbers.write(out, Name.X, bodies.x[entity]);
        JsonNumbers.write(out, Name.Y, bodies.y[entity]);
        JsonNumbers.write(out, Name.VX, bodies.vx[entity]);
        JsonNumbers.write(out, Name.VY, bodies.vy[entity]);
        switch (kind) {
            case WIZARD -> writeWizard(out, pitch, entity);
            case BLUDGER -> JsonNumbers.write(out, Name.VICTIM, (int) bodies.columns[Pitch.LAST_VICTIM][entity]);
            default -> {
                if (kind != EntityKind.LOST_SNAFFLE) {
                    JsonNumbers.write(out, Name.HELD, kind == EntityKind.HELD_SNAFFLE);
                }
                if (whole) {
                    writeIgnored(out, pitch, entity);
                }
            }
        }
    }

    private static void writeIgnored(JsonGenerator out, Pitch pitch, int snaffle) {
        out.writeName(Name.IGNORED);
        out.writeStartArray();
        for (int other = Pitch.WIZARDS; other < Pitch.WIZARDS + pitch.snaffles(); other++) {
            if (Pitch.ignores(pitch.bodies(), snaffle, other)) {
                out.writeNumber(other);
            }
        }
        out.writeEndArray();
    }

    /** The spells at work, and the one that begins with the next turn. */
    private static void writeWizard(JsonGenerator out, Pitch pitch, int wizard) {
        SpellBook spells = pitch.spells();
        JsonNumbers.write(out, Name.SNAFFLE, pitch.held(wizard));
        JsonNumbers.write(out, Name.WAIT, (int) pitch.bodies().columns[Pitch.WAIT][wizard]);
        out.writeName(Name.SPELLS);
        out.writeStartArray();
        for (int k = 0; k < Spell.count(); k++) {
            Spell spell = Spell.of(k);
            if (spells.turns(wizard, spell) > 0) {
                out.writeStartObject();
                out.writeName(Name.SPELL);
                out.writeString(spell.text());
                JsonNumbers.write(out, Name.TURNS, spells.turns(wizard, spell));
                JsonNumbers.write(out, Name.TARGET, spells.target(wizard, spell));
                out.writeEndObject();
            }
        }
        out.writeEndArray();
        if (spells.cast(wizard) != null) {
            out.writeName(Name.CAST);
            out.writeStartObject();
            out.writeName(Name.SPELL);
            out.writeString(spells.cast(wizard).text());
            JsonNumbers.write(out, Name.TARGET, spells.castAt(wizard));
            out.writeEndObject();
        }
    }
}
