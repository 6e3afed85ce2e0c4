package steward.replay.page;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.params.provider.Arguments.arguments;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import steward.cli.shared.Games;

/** Details of a page: the line of stderr that says why a bot failed, and the frames of a guest that is not run. */
class PageDetailsTest {

    /** A guest whose second bot was asked, and failed; its referee is a program that there is not. */
    private static final String REPLAY = """
        {"type":"steward-replay","format":3,"angles":"correctly-rounded","game":"guest","seed":"3","players":[\
        {"name":"one","bot":"codingame:a","protocol":"codingame"},\
        {"name":"two","bot":"codingame:b","protocol":"codingame"}],"timeFactor":1,\
        "scene":{"name":"small","game":"guest","players":2,"referee":{"command":["none"]}},\
        "drawing":{"field":{"x":0,"y":0,"width":1600,"height":900},"walls":[],"zones":[],"bodies":[]},\
        "start":{"state":{"bodies":[],"asked":1,"said":[{"block":"NEXT_PLAYER_INPUT","lines":["20","a b"]},\
        {"block":"NEXT_PLAYER_INFO","lines":["1","1","50"]}]},"hash":"0000000000000001"},\
        "headerHash":"0000000000000001"}
        {"type":"turn","turn":1,"commands":[null,null],"faults":[null,"FAULT"],"outcome":{"state":{"bodies":[],\
        "said":[{"block":"SCORES","lines":["0 0","1 1"]}]},"hash":"0000000000000002"},"stderr":[null,"STDERR"],\
        "turnHash":"0000000000000002"}
        """;

    static Stream<Arguments> failures() {
        return Stream.of(
            arguments("exited with status 1 before answering", "depth 3\\n  File \\\"bot.py\\\", line 3, in f\\n"
                + "    x()\\nKeyError: 3\\nbye\\n", "[[1,1,3]]"),
            arguments("exited with status 1 before answering", "one\\ntwo\\n\\n", "[[1,1,1]]"),
            arguments("not a number", "one\\ntwo\\n", "[]"),
            arguments("exited with status 1 before answering", "\\n", "[]"));
    }

    @ParameterizedTest
    @MethodSource("failures")
    void theLineThatSaysWhyComesFirstAndFramesBehindIt(String fault, String stderr, String errors) {
        byte[] replay = REPLAY.replace("FAULT", fault).replace("STDERR", stderr).getBytes(StandardCharsets.UTF_8);
        List<String> lines = new String(PageDetails.of(replay, "x.jsonl", Games.types()), StandardCharsets.UTF_8)
            .lines().toList();
        assertEquals(errors, lines.get(0));
        assertEquals("[null,\"20\\na b\"]", lines.get(2), lines.toString());
        assertEquals(List.of(errors), new String(PageDetails.of(replay, "x.jsonl", null), StandardCharsets.UTF_8)
            .lines().toList(), "without games there are no frames");
    }
}
