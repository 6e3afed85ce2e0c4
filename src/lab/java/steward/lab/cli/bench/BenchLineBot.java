package steward.lab.cli.bench;

import java.util.ArrayList;
import java.util.List;
import steward.bot.Bot;
import steward.json.JsonNumbers;
import tools.jackson.core.JsonParser;
import tools.jackson.core.JsonToken;
import tools.jackson.core.ObjectReadContext;

/** The bot {@link BenchDirectBot} with lines: it reads frames and answers in text. */
public final class BenchLineBot implements Bot {

    private final List<double[]> checkpoints = new ArrayList<>();
    private final double[] place = new double[2];
    private final StringBuilder answer = new StringBuilder();
    private int player;

    @Override
    public void setup(String line) {
        try (JsonParser in = JsonNumbers.FACTORY.createParser(ObjectReadContext.empty(), line)) {
            in.nextToken();
            while (in.nextToken() == JsonToken.PROPERTY_NAME) {
                String name = in.currentName();
                in.nextToken();
                if (name.equals("player")) {
                    player = in.getIntValue();
                } else if (name.equals("checkpoints")) {
                    readCheckpoints(in);
                } else {
                    in.skipChildren();
                }
            }
        }
    }

    private void readCheckpoints(JsonParser in) {
        while (in.nextToken() == JsonToken.START_OBJECT) {
            while (in.nextToken() == JsonToken.PROPERTY_NAME) {
                int k = in.currentName().equals("x") ? 0 : 1;
                in.nextToken();
                place[k] = in.getDoubleValue();
            }
            checkpoints.add(place.clone());
        }
    }

    @Override
    public String turn(String line) {
        answer.setLength(0);
        answer.append("{\"pods\":[");
        try (JsonParser in = JsonNumbers.FACTORY.createParser(ObjectReadContext.empty(), line)) {
            in.nextToken();
            while (in.nextToken() == JsonToken.PROPERTY_NAME) {
                boolean pods = in.currentName().equals("pods");
                in.nextToken();
                while (pods && in.nextToken() == JsonToken.START_OBJECT) {
                    readPod(in);
                }
            }
        }
        return answer.append("]}").toString();
    }

    private void readPod(JsonParser in) {
        int owner = 0;
        int next = 0;
        while (in.nextToken() == JsonToken.PROPERTY_NAME) {
            String name = in.currentName();
            in.nextToken();
            switch (name) {
                case "player" -> owner = in.getIntValue();
                case "vx" -> place[0] = in.getDoubleValue();
                case "vy" -> place[1] = in.getDoubleValue();
                case "nextCheckpoint" -> next = in.getIntValue();
                default -> in.skipChildren();
            }
        }
        if (owner == player) {
            answer.append(answer.charAt(answer.length() - 1) == '[' ? "" : ",")
                .append("{\"x\":").append(checkpoints.get(next)[0] - place[0])
                .append(",\"y\":").append(checkpoints.get(next)[1] - place[1])
                .append(",\"thrust\":").append(BenchDirectBot.THRUST).append('}');
        }
    }
}
