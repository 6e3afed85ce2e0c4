package steward.codingame.recording;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import tools.jackson.databind.JsonNode;

/**
 * Facts about a game in the site's JSON besides its frames: names and numbers of the players, number of the game.
 *
 * @param names   per player who it was: {@code agents[].codingamer.pseudo}, of a boss its nickname, of a
 *                game of the SDK's runner its name; {@code player N} where that is not recorded
 * @param data    of the game: its number; empty if not recorded
 * @param players per player: the number of the agent, and the league, as far as recorded
 */
record RecordingFacts(List<String> names, Map<String, String> data, List<Map<String, String>> players) {

    private static final int LONGEST_NAME = 60;

    static RecordingFacts of(JsonNode result, int players) {
        List<String> names = new ArrayList<>();
        List<Map<String, String>> data = new ArrayList<>();
        for (int player = 0; player < players; player++) {
            names.add("player " + player);
            data.add(new TreeMap<>());
        }
        for (JsonNode agent : result.path("agents")) {
            int player = agent.path("index").asInt(-1);
            if (player >= 0 && player < players) {
                String pseudo = agent.path("codingamer").path("pseudo").asString("");
                String boss = agent.path("arenaboss").path("nickname").asString(agent.path("name").asString(""));
                String name = pseudo.isBlank() ? boss : pseudo;
                if (!name.isBlank()) {
                    names.set(player, name.substring(0, Math.min(LONGEST_NAME, name.length())));
                }
                put(data.get(player), "agent", agent.path("agentId"));
                JsonNode league = agent.path("league");
                put(data.get(player), "league", league.isObject() ? league.path("divisionIndex") : league);
            }
        }
        Map<String, String> game = new TreeMap<>();
        put(game, "game", result.path("gameId"));
        return new RecordingFacts(names, game, data);
    }

    private static void put(Map<String, String> data, String name, JsonNode value) {
        if (value.isNumber() || value.isString()) {
            data.put(name, value.asString());
        }
    }
}
