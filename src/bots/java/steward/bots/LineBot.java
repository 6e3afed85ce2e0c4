package steward.bots;

import java.io.BufferedReader;
import java.io.FileDescriptor;
import java.io.FileInputStream;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import tools.jackson.core.JsonParser;
import tools.jackson.core.JsonToken;
import tools.jackson.core.ObjectReadContext;
import tools.jackson.core.json.JsonFactory;

/**
 * A bot that uses JSON lines: a setup line, then a line per turn, each answered with one line, then an end line. An
 * answer follows from the setup and the turn alone.
 */
public abstract class LineBot {

    private final String game;
    private final JsonFactory json = new JsonFactory();

    /** @param game that it plays, as the setup names it */
    protected LineBot(String game) {
        this.game = game;
    }

    /** Reads the value of a frame's field. Fields that the bot does not use are skipped. */
    protected abstract void read(String field, JsonParser in);

    /** Returns the answer to the turn that was read, without line end. */
    protected abstract String decide();

    /** Plays one match over the standard streams. */
    protected final void run() throws IOException {
        BufferedReader in = new BufferedReader(
            new InputStreamReader(new FileInputStream(FileDescriptor.in), StandardCharsets.UTF_8));
        PrintStream out = System.out;
        for (String line = in.readLine(); line != null; line = in.readLine()) {
            String answer = answer(line);
            if (answer != null) {
                out.println(answer);
                out.flush();
            }
        }
    }

    /**
     * The answer to a frame, {@code null} if it wants none.
     *
     * @throws IllegalArgumentException if it is the setup of another game
     */
    public final String answer(String line) {
        boolean turn = false;
        try (JsonParser in = json.createParser(ObjectReadContext.empty(), line)) {
            in.nextToken();
            while (in.nextToken() == JsonToken.PROPERTY_NAME) {
                String field = in.currentName();
                in.nextToken();
                if (field.equals("type")) {
                    turn = in.getString().equals("turn");
                } else if (!field.equals("game")) {
                    read(field, in);
                } else if (!in.getString().equals(game)) {
                    throw new IllegalArgumentException("this bot plays " + game + ", not " + in.getString());
                }
            }
        }
        return turn ? decide() : null;
    }

    /** Reads an array of whole numbers into a list. */
    protected static void readNumbers(JsonParser in, List<Integer> numbers) {
        numbers.clear();
        while (in.nextToken() != JsonToken.END_ARRAY) {
            numbers.add(in.getIntValue());
        }
    }
}
