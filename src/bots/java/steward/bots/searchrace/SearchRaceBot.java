package steward.bots.searchrace;

import steward.bots.LineBot;
import tools.jackson.core.JsonParser;
import tools.jackson.core.JsonToken;

/** A bot for the search race. */
abstract class SearchRaceBot extends LineBot {

    private final Course course = new Course();
    private final Car car = new Car();
    private final Command command = new Command();

    SearchRaceBot() {
        super("search-race");
    }

    /** Decides one turn. */
    abstract void decide(Course race, Car now, Command command);

    @Override
    protected final String decide() {
        decide(course, car, command);
        return "{\"turn\":" + command.degrees + ",\"thrust\":" + command.thrust + "}";
    }

    @Override
    protected final void read(String field, JsonParser in) {
        switch (field) {
            case "laps" -> course.laps = in.getIntValue();
            case "checkpointRadius" -> course.radius = in.getDoubleValue();
            case "drag" -> course.drag = in.getDoubleValue();
            case "checkpoints" -> readCheckpoints(in);
            case "car" -> readCar(in);
            default -> in.skipChildren();
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
