package steward.json;

import java.util.ArrayList;
import java.util.List;
import java.util.function.IntFunction;
import java.util.function.IntPredicate;
import java.util.function.IntToDoubleFunction;
import java.util.function.IntUnaryOperator;
import java.util.function.ObjIntConsumer;
import steward.physics.Bodies;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.SerializableString;
import tools.jackson.core.io.SerializedString;

/**
 * Fields of the objects of one kind, in their order, each with the value that an object has by its index: the one list
 * of what frames and states say of a body. Names are encoded once; writing allocates nothing.
 */
public final class ObjectFields {

    private final List<Field> fields = new ArrayList<>();

    private static final class Field {
        private final SerializableString name;
        private final ObjIntConsumer<JsonGenerator> value;
        private IntPredicate condition;
        private boolean stateOnly;

        Field(String name, ObjIntConsumer<JsonGenerator> value) {
            this.name = new SerializedString(name);
            this.value = value;
        }
    }

    /** Adds a field of any form. @param value writes the value of an object. @return this */
    public ObjectFields value(String name, ObjIntConsumer<JsonGenerator> value) {
        fields.add(new Field(name, value));
        return this;
    }

    /** Adds a finite number. @return this */
    public ObjectFields number(String name, IntToDoubleFunction number) {
        return value(name, (out, k) -> JsonNumbers.write(out, number.applyAsDouble(k)));
    }

    /** Adds a whole number. @return this */
    public ObjectFields whole(String name, IntUnaryOperator number) {
        return value(name, (out, k) -> out.writeNumber(number.applyAsInt(k)));
    }

    /** Adds a text. @return this */
    public ObjectFields text(String name, IntFunction<String> text) {
        return value(name, (out, k) -> out.writeString(text.apply(k)));
    }

    /** Adds a value that is true or false. @return this */
    public ObjectFields flag(String name, IntPredicate flag) {
        return value(name, (out, k) -> out.writeBoolean(flag.test(k)));
    }

    /** Adds the fields {@code x}, {@code y}, {@code vx} and {@code vy} of bodies. @return this */
    public ObjectFields motion(Bodies bodies) {
        return number("x", k -> bodies.x[k]).number("y", k -> bodies.y[k])
            .number("vx", k -> bodies.vx[k]).number("vy", k -> bodies.vy[k]);
    }

    /** Leaves out the field last added, but of some objects. @return this */
    public ObjectFields where(IntPredicate condition) {
        last().condition = condition;
        return this;
    }

    /** Leaves out the field last added of frames: only the game needs it to go on. @return this */
    public ObjectFields inStates() {
        last().stateOnly = true;
        return this;
    }

    private Field last() {
        return fields.get(fields.size() - 1);
    }

    /** Writes an object. @param whole true for a state, false for a frame */
    public void write(JsonGenerator out, int index, boolean whole) {
        out.writeStartObject();
        for (int k = 0; k < fields.size(); k++) {
            Field field = fields.get(k);
            if ((whole || !field.stateOnly) && (field.condition == null || field.condition.test(index))) {
                out.writeName(field.name);
                field.value.accept(out, index);
            }
        }
        out.writeEndObject();
    }

    /** Writes one field, an array with the objects of the first indices. @param whole as above */
    public void writeAll(JsonGenerator out, SerializableString name, int count, boolean whole) {
        out.writeName(name);
        out.writeStartArray();
        for (int k = 0; k < count; k++) {
            write(out, k, whole);
        }
        out.writeEndArray();
    }
}
