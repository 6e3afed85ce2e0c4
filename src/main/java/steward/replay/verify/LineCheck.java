package steward.replay.verify;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import steward.bot.LineBuffer;
import steward.game.Game;
import steward.match.MatchResult;
import steward.match.Turn;
import steward.replay.JsonLine;
import steward.replay.OutcomeJson;
import steward.replay.RecordedTurn;
import steward.replay.ReplayHeader;
import steward.replay.ReplayLines;
import steward.replay.ReplayReader;
import steward.replay.ServerRecording;

/**
 * Comparison of recorded lines with a match that is played again. Every line is written again, from the recorded inputs
 * and the recomputed outcome, and its bytes up to {@code times} are compared: nothing can be added, left out, doubled,
 * moved or spelled differently. If they differ, the first difference is found.
 */
final class LineCheck {

    private static final int OUTCOME_NAME = ",\"outcome\":".length();
    private static final int SHOWN = 40;

    private final ReplayReader replay;
    private final Resimulation again;
    private final Game game;
    private final SignedLines signed;
    /** Recording by a server, as far as it is read; {@code null} but in an imported match. */
    private final ServerRecording server;
    private final ViewComparison views;
    private final ReplayLines lines;
    /** The turn that {@link #isSame} has played, or {@code null}; and whether its line is written to its end. */
    private Turn played;
    private boolean finished;
    private int outcomeFrom;
    private int outcomeTo;

    /** @param views compares what a server has shown; {@code null} if nothing can be compared with it */
    LineCheck(ReplayReader replay, Resimulation again, ViewComparison views) {
        this.replay = replay;
        this.again = again;
        signed = new SignedLines(replay);
        game = again.game();
        server = replay.imported() ? new ServerRecording() : null;
        this.views = views;
        ReplayHeader header = replay.header();
        lines = new ReplayLines(new ReplayHeader(header.game(), again.setup().scene().json(), header.seed(),
            header.names(), header.bots(), header.protocols(), header.timeFactor(), header.law(),
            header.signer()).ofJar(header.jar()).ofLimits(header.limits()), server);
    }

    /** Verifies the replay from its first turn to its end or cut. */
    Verification verify() {
        ReplayDifference difference = header();
        String[] faults = new String[game.players()];
        int turns = 0;
        int states = 0;
        boolean whole = false;
        while (difference == null && !whole) {
            byte[] line = replay.nextLine();
            boolean same = line != null && isSame(line);
            RecordedTurn turn = same ? null : replay.turn(line);
            if (!same && turn == null && replay.result() == null) {
                break;
            }
            if (same) {
                replay.passed(turns + 1);
            } else if (turn == null) {
                difference = result(faults);
                whole = difference == null;
            } else {
                difference = turn(line, turn);
            }
            if (difference == null && !whole) {
                turns += views == null || views.difference() == null ? 1 : 0;
                states += server == null && OutcomeJson.hasState(game) ? 1 : 0;
                for (int player = 0; turn != null && player < faults.length; player++) {
                    faults[player] = faults[player] == null ? turn.faults()[player] : faults[player];
                }
            }
        }
        return new Verification(turns, views == null ? states : views.turns(), whole,
            views == null || views.difference() == null ? difference : views.difference(), replay.warning(), null,
            signed.check(whole));
    }

    ReplayDifference header() {
        read(replay.headerLine());
        lines.header(game, again.codec());
        boolean agrees = agrees(replay.headerLine().json());
        ReplayDifference difference = agrees ? null : RecordedJson.compareOpening(replay, again);
        if (difference == null && !agrees) {
            difference = lineDiffers(0, "headerHash", replay.headerLine());
        }
        if (difference == null && views != null) {
            views.start(server.frames(0));
        }
        lines.end();
        return difference;
    }

    /** Takes what a server has recorded in a line. */
    private void read(JsonLine line) {
        if (server != null) {
            server.read(line);
        }
    }

    boolean isSame(byte[] line) {
        played = null;
        int number = game.turn() + 1;
        int at = server != null || game.isOver() ? -1 : LineScanner.commands(line, number);
        int rest = at < 0 ? -1 : again.readCommands(line, at, line.length);
        if (rest < 0 || LineScanner.outcome(line, line.length - rest) < 0) {
            return false;
        }
        Turn turn = Turn.of(number, game.players());
        for (int player = 0; player < game.players(); player++) {
            if (game.isAsked(player)) {
                turn.answer(player, null, null, 0);
            }
        }
        play(turn);
        played = turn;
        finished = LineScanner.hash(line, outcomeTo) >= 0;
        if (!finished) {
            return false;                                     // messages are known only after parsing
        }
        lines.texts(turn);
        boolean same = LineScanner.isTimes(line, lines.line().size()) && agrees(line);
        if (same) {
            lines.end();
        }
        return same;
    }

    private void play(Turn turn) {
        lines.commands(turn, again.codec());
        outcomeFrom = lines.line().size() + OUTCOME_NAME;
        game.play();
        lines.outcome(game, again.codec());
        outcomeTo = lines.line().size();
    }

    ReplayDifference turn(byte[] line, RecordedTurn recorded) {
        if (server != null) {
            read(new JsonLine(recorded.where(), line));
        }
        if (played == null) {
            Turn turn = Turn.of(recorded.number(), game.players());
            for (int player = 0; player < game.players(); player++) {
                if (game.isAsked(player) && recorded.asked(player)) {
                    fill(turn, recorded, player);
                }
            }
            ReplayDifference wrong = again.prepare(recorded);
            if (wrong != null) {
                return wrong;
            }
            if (views != null) {
                views.before();
            }
            play(turn);
            lines.texts(turn);
        } else if (!finished) {
            for (int player = 0; player < game.players(); player++) {
                if (played.asked(player)) {
                    fill(played, recorded, player);
                }
            }
            lines.texts(played);
        }
        boolean agrees = agrees(line);
        ReplayDifference difference = agrees ? null : RecordedJson.compare(recorded.number(), recorded.outcome(),
            Arrays.copyOfRange(lines.line().bytes(), outcomeFrom, outcomeTo));
        if (difference == null && !agrees) {
            difference = lineDiffers(recorded.number(), "turnHash", new JsonLine(recorded.where(), line));
        }
        if (difference == null && views != null) {
            views.turn(recorded, server.frames(recorded.number()));
        }
        lines.end();
        return difference;
    }

    /** Only a player that is asked can fail, answer or write. */
    private static void fill(Turn turn, RecordedTurn recorded, int player) {
        if (recorded.faults()[player] != null) {
            turn.fail(player, recorded.faults()[player], recorded.stderr()[player], 0);
        } else {
            turn.answer(player, recorded.messages()[player], recorded.stderr()[player], 0);
        }
    }

    private ReplayDifference result(String[] turnFaults) {
        JsonLine result = replay.result();
        read(result);
        String[] recorded = result.textsOf("players", "fault");
        String[] faults = turnFaults.clone();
        for (int player = 0; player < Math.min(faults.length, recorded.length); player++) {
            if (faults[player] == null && recorded[player] != null && game.isOver()) {   // older replays name none
                faults[player] = game.expulsion(player);
            }
        }
        ReplayDifference difference = end(game, result.integer("turns"), result.text("ending"));
        difference = difference != null ? difference : RecordedJson.compareStanding(replay, game);
        difference = difference != null ? difference : players(game.turn(), replay.header().names(), faults,
            result.textsOf("players", "name"), recorded);
        if (difference != null) {
            return difference;
        }
        List<MatchResult.PlayerResult> players = new ArrayList<>();
        for (JsonLine player : result.objects("players")) {
            players.add(new MatchResult.PlayerResult(player.text("name"), 0, 0, faults[players.size()], null, 0, 0, 0,
                0, 0, data(player)));
        }
        lines.result(game, new MatchResult(game.turn(), game.ending(), players, data(result)));
        difference = agrees(result.json()) ? null : lineDiffers(game.turn(), "resultHash", result);
        if (difference == null && views != null && server.end() != null) {
            views.end(server.end());
        }
        lines.end();
        return difference;
    }

    private static Map<String, String> data(JsonLine line) {
        Map<String, String> data = new HashMap<>();
        if (line.has("data")) {
            JsonLine recorded = new JsonLine(line.where() + ": data", line.object("data"));
            for (String name : recorded.names()) {
                data.put(name, recorded.text(name));
            }
        }
        return data;
    }

    /** True if a recorded line is the one that was written; then it is signed. */
    private boolean agrees(byte[] line) {
        LineBuffer written = lines.line();
        int size = written.size();
        boolean agrees = size <= line.length && Arrays.equals(line, 0, size, written.bytes(), 0, size)
            && LineScanner.isEnd(line, size);
        if (agrees) {
            signed.add(line, size);
        }
        return agrees;
    }

    /**
     * The difference of a line whose values agree: its hash is wrong, or was computed for another spelling of the line.
     */
    private ReplayDifference lineDiffers(int turn, String hash, JsonLine line) {
        ReplayDifference difference = RecordedJson.compareHash(turn, hash, line);
        if (difference != null) {
            return difference;
        }
        LineBuffer written = lines.line();
        byte[] bytes = line.json();
        int at = Arrays.mismatch(bytes, 0, bytes.length, written.bytes(), 0, written.size());
        return new ReplayDifference(turn, "byte " + (at + 1) + " of the line", shown(bytes, at, bytes.length),
            shown(written.bytes(), at, written.size()));
    }

    private static String shown(byte[] bytes, int from, int to) {
        return from >= to ? "the end" : new String(bytes, from, Math.min(SHOWN, to - from), StandardCharsets.UTF_8);
    }

    /** The result is there although the match is not over, or is not that of this match. */
    private static ReplayDifference end(Game game, int turns, String ending) {
        if (!game.isOver()) {
            return new ReplayDifference(game.turn(), "result", "an end of the match", "the match goes on");
        }
        if (turns != game.turn()) {
            return new ReplayDifference(game.turn(), "turns", Integer.toString(turns), Integer.toString(game.turn()));
        }
        return ending.equals(game.ending()) ? null : new ReplayDifference(game.turn(), "ending", ending, game.ending());
    }

    /** Names and faults of the result are those of the header and the turns. */
    private static ReplayDifference players(int turn, List<String> names, String[] faults, String[] recordedNames,
                              String[] recordedFaults) {
        if (recordedNames.length != names.size()) {
            return new ReplayDifference(turn, "players", recordedNames.length + " entries", names.size() + " entries");
        }
        for (int player = 0; player < faults.length; player++) {
            String field = "players[" + player + "].";
            if (!names.get(player).equals(recordedNames[player])) {
                return new ReplayDifference(turn, field + "name", String.valueOf(recordedNames[player]),
                    names.get(player));
            }
            if (!said(faults[player]).equals(said(recordedFaults[player]))) {
                return new ReplayDifference(turn, field + "fault", said(recordedFaults[player]), said(faults[player]));
            }
        }
        return null;
    }

    private static String said(String fault) {
        return fault == null ? "nothing" : fault;
    }
}
