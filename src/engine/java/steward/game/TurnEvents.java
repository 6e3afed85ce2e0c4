package steward.game;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.IntFunction;

/** Reusable columns for the events of a turn: as long as nothing asks for a list, no object is created. */
public final class TurnEvents {

    private static final int ROOM = 16;
    private static final int QUANTITIES = 3;

    private TurnEvent.Kind[] kinds = new TurnEvent.Kind[ROOM];
    private int[] bodies = new int[ROOM];
    private double[] quantities = new double[QUANTITIES * ROOM];
    private String[] texts = new String[ROOM];
    private IntFunction<String>[] textsOf = functions(ROOM);
    private int[] numbers = new int[ROOM];
    private boolean[] headlines = new boolean[ROOM];
    private int size;

    /** Adds an event; the parameters are those of {@link TurnEvent}. */
    public void add(TurnEvent.Kind kind, double time, int body, double x, double y, String text, boolean headline) {
        add(kind, time, body, x, y, null, 0, headline);
        texts[size - 1] = text;
    }

    /**
     * Adds an event whose text is made of a number, when a list is asked for.
     *
     * @param textOf the text of a number, the same every time
     */
    public void add(TurnEvent.Kind kind, double time, int body, double x, double y, IntFunction<String> textOf,
                    int number, boolean headline) {
        if (size == kinds.length) {
            grow();
        }
        kinds[size] = kind;
        bodies[size] = body;
        quantities[QUANTITIES * size] = time;
        quantities[QUANTITIES * size + 1] = x;
        quantities[QUANTITIES * size + 2] = y;
        texts[size] = null;
        textsOf[size] = textOf;
        numbers[size] = number;
        headlines[size] = headline;
        size++;
    }

    @SuppressWarnings("unchecked")
    private static IntFunction<String>[] functions(int count) {
        return (IntFunction<String>[]) new IntFunction<?>[count];
    }

    private void grow() {
        int room = 2 * size;
        kinds = Arrays.copyOf(kinds, room);
        bodies = Arrays.copyOf(bodies, room);
        quantities = Arrays.copyOf(quantities, QUANTITIES * room);
        texts = Arrays.copyOf(texts, room);
        textsOf = Arrays.copyOf(textsOf, room);
        numbers = Arrays.copyOf(numbers, room);
        headlines = Arrays.copyOf(headlines, room);
    }

    public void clear() {
        size = 0;
    }

    public int size() {
        return size;
    }

    /** The body of event k, -1 for none. */
    public int body(int k) {
        return bodies[k];
    }

    /** The events in order; a new list, which does not change with the next turn. */
    public List<TurnEvent> list() {
        if (size == 0) {
            return List.of();
        }
        List<TurnEvent> list = new ArrayList<>(size);
        for (int k = 0; k < size; k++) {
            String text = texts[k] == null ? textsOf[k].apply(numbers[k]) : texts[k];
            list.add(new TurnEvent(kinds[k], quantities[QUANTITIES * k], bodies[k], quantities[QUANTITIES * k + 1],
                quantities[QUANTITIES * k + 2], text, headlines[k]));
        }
        return list;
    }
}
