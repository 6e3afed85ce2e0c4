package com.codingame.gameengine.core;

import java.io.InputStream;
import java.io.PrintStream;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.Scanner;

/**
 * A stand-in for the SDK: it speaks its blocks and calls a class Referee of the project, loaded beside it. Scores are
 * the numbers that bots say, and chance that follows from the seed. Bots are told the property "seen", if the
 * referee sets it. The value "points" of a game for one is what is left of them to 100.5.
 */
public class RefereeMain {

    private static boolean inProduction = false;

    public static void start(InputStream is, PrintStream out) throws Exception {
        Scanner in = new Scanner(is);
        List<String> init = hear(in);
        int players = Integer.parseInt(init.get(1));
        String seed = init.get(2).substring(init.get(2).indexOf('=') + 1);
        int games = Integer.getInteger("games", 0) + 1;
        System.setProperty("games", Integer.toString(games));
        System.out.println("noise of the referee");
        Class<?> referee = Class.forName("Referee");
        int[] sums = new Random(Long.parseLong(seed)).ints(players, 0, 9).toArray();
        for (int turn = 0; turn < 4; turn++) {
            for (int player = 0; player < players; player++) {
                hear(in);
                String said = (String) referee.getMethod("turn", int.class, long.class, int.class).invoke(null, turn,
                    Long.parseLong(seed), games);
                say(out, "VIEW", "KEY_FRAME " + turn);
                say(out, "SUMMARY", said, "level " + System.getProperty("league.level"), "\u00e4 " + inProduction);
                say(out, "NEXT_PLAYER_INPUT", "turn " + turn + System.getProperty("seen", ""));
                say(out, "NEXT_PLAYER_INFO", "" + player, "1", "1000");
                out.flush();
                List<String> answer = hear(in);
                String word = answer.get(answer.size() - 1);
                sums[player] += word.matches("\\d") ? Integer.parseInt(word) : 0;
            }
        }
        hear(in);
        List<String> scores = new ArrayList<>();
        for (int player = 0; player < players; player++) {
            scores.add(player + " " + sums[player]);
        }
        if (System.getProperty("game.mode", "multi").equals("solo")) {
            say(out, "METADATA", "{\"points\":\"" + (100.5 - sums[0]) + "\",\"word\":\"x\"}");
        }
        say(out, "SCORES", scores.toArray(new String[0]));
        out.flush();
    }

    private static List<String> hear(Scanner in) {
        List<String> lines = new ArrayList<>();
        lines.add(in.nextLine());
        for (int count = Integer.parseInt(lines.get(0).replaceAll("\\D", "")); count > 0; count--) {
            lines.add(in.nextLine());
        }
        return lines;
    }

    private static void say(PrintStream out, String name, String... lines) {
        out.println("[[" + name + "] " + lines.length + "]");
        for (String line : lines) {
            out.println(line);
        }
    }
}
