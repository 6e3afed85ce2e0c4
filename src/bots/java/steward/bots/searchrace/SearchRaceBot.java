package steward.bots.searchrace;

import java.io.BufferedReader;
import java.io.FileDescriptor;
import java.io.FileInputStream;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import tools.jackson.core.JsonParser;
import tools.jackson.core.JsonToken;
import tools.jackson.core.ObjectReadContext;
import tools.jackson.core.json.JsonFactory;

/**
 * A bot for the search race that uses JSON lines: a setup line, then a line per turn, each answered with one line, then
 * an end line. Equal lines get equal answers.
 */
abstract class SearchRaceBot {

    private static final String GAME = "search-race";

    private final JsonFactory json = new JsonFactory();
    private final Course course = new Course();
    private final Car car = new Car();
    private final Command command = new Command();

    /** Decides one turn. */
    abstract void decide(Course race, Car now, Command command);

    /** Plays one match over the standard streams. */
    final void run() throws IOException {
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
    final String answer(String line) {
        boolean turn = false;
        try (JsonParser in = json.createParser(ObjectReadContext.empty(), line)) {
            in.nextToken();
            while (in.nextToken() == JsonToken.PROPERTY_NAME) {
                String name = in.currentName();
                in.nextToken();
                switch (name) {
                    case "type" -> turn = in.getString().equals("turn");
                    case "game" -> requireGame(in.getString());
                    case "laps" -> course.laps = in.getIntValue();
                    case "checkpointRadius" -> course.radius = in.getDoubleValue();
                    case "drag" -> course.drag = in.getDoubleValue();
                    case "checkpoints" -> readCheckpoints(in);
                    case "car" -> readCar(in);
                    default -> in.skipChildren();
                }
            }
        }
        if (!turn) {
            return null;
        }
        decide(course, car, command);
        return "{\"turn\":" + command.degrees + ",\"thrust\":" + command.thrust + "}";
    }

    private static void requireGame(String game) {
        if (!game.equals(GAME)) {
            throw new IllegalArgumentException("this bot plays " + GAME + ", not " + game);
        }
    }

    private void readCheckpoints(JsonParser in) {
        course.clear();
        while (in.nextToken() == JsonToken.START_OBJECT) {
            double x = 0;
            double y = 0;
            while (in.nextToken() == JsonToken.PROPERTY_NAME) {
                boolean first = in.currentName().equals("x");
                in.nextToken();
                x = first ? in.getDoubleValue() : x;
                y = first ? y : in.getDoubleValue();
            }
            course.add(x, y);
        }
    }

    private void readCar(JsonParser in) {
        while (in.nextToken() == JsonToken.PROPERTY_NAME) {
            String name = in.currentName();
            in.nextToken();
            switch (name) {
                case "x" -> car.x = in.getDoubleValue();
                case "y" -> car.y = in.getDoubleValue();
                case "vx" -> car.vx = in.getDoubleValue();
                case "vy" -> car.vy = in.getDoubleValue();
                case "heading" -> car.heading = in.getDoubleValue();
                case "passed" -> car.passed = in.getIntValue();
                default -> in.skipChildren();
            }
        }
    }
}
