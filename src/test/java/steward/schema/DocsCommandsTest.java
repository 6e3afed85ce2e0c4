package steward.schema;

import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import steward.bot.command.CommandLine;

/**
 * Lines of README and manual, run by a shell as they stand there, in a folder with the bots that they name; and the
 * examples of {@code src/examples} that need nothing else. Only time limits are longer than shown: the machine may be
 * busy. It takes long because each line starts the program. A play is made of steps, one a line:
 * <pre>
 * PAGE ```LANGUAGE WORDS > FILE writes the block that begins so
 * PAGE $ WORDS => STATUS TEXT   runs the line that begins so; it ends with the status and says what matches the text
 * $ LINE => STATUS TEXT         runs a line of this table
 * </pre>
 */
@Tag("process")
@Tag("slow")
@Timeout(300)
@Execution(ExecutionMode.CONCURRENT)
class DocsCommandsTest {

    private static final Pattern STEP = Pattern.compile(
        "(\\S+\\.md)? ?(?:```(\\w*)(?: (.*))? > (\\S+)|\\$ (.*?) => (\\d) ?(.*))");
    /** The races name no seed, so on the map that is drawn either may win. */
    private static final String RACE_END = "finished after 3 laps|is out: no checkpoint in 101 turns";
    private static final String ROOT = Path.of("").toAbsolutePath().toString();
    private static final String JAVA = CommandLine.quote(List.of(Path.of(System.getProperty("java.home"), "bin", "java")
        .toString(), "-cp", System.getProperty("java.class.path")));

    /**
     * Without air a ball that falls h = 100 u at g = 2 arrives at t = 10 and jumps to e^2 h = 64 u, at t = 18. From the
     * middle of its first parabola, at a speed of 1, the ball of drop falls n (n + 1) u in n turns: 690 u in turn 26.
     */
    private static final String PLAYS = """
        README.md ```python > bot.py
        README.md $ steward match --bot 'me=python3 bot.py' --bot builtin:racer => 0 RACE_END
        README.md $ steward replay match.jsonl --verify => 0 verified:

        docs/tables/simulate.md ``` 4 > tests.txt
        docs/tables/simulate.md ``` 12755 > states.txt
        docs/library.md $ steward simulate < tests.txt => 0 ^12755
        $ steward simulate < tests.txt | cmp - states.txt => 0 ^$

        $ JAVA "ROOT/src/examples/library/DroppedBall.java" > gaps.txt && wc -l < gaps.txt => 0 ^\\s*100$
        $ awk '/^(10|18|100) / && ($2 - ($1 == 18) * 64)^2 > 1e-18' gaps.txt => 0 ^$

        $ sh "ROOT/src/examples/shell/moving-picture.sh" => 0
        $ head -c 4 corner.svg && grep -o '<animate' corner.svg | wc -l => 0 ^<svg\\s*(1[2-9]|[2-9]\\d|\\d{3})

        docs/scenes.md ```json { "name": "drop" > drop.json
        docs/scenes.md $ steward run drop.json => 0 turns, all bodies are slower than the scene's restBelow
        docs/scenes.md $ steward replay drop.jsonl => 0 verified:
        $ wc -c < drop.html && sed -n 2p drop/impacts.csv => 0 \\d{5,}\\s+26,
        $ cp "ROOT/docs/scenes/plot.py" . => 0
        docs/scenes.md $ python3 plot.py drop/states.csv y => 0
        $ grep 'y \\[u\\]: 100 to 7' drop.svg => 0
        $ echo $(grep -o 'points="[^"]*"' drop.svg | wc -w) $(sed 1d drop/states.csv | wc -l) => 0 ^(\\d+) \\1$

        $ cp "ROOT/docs/scenes/break.json" "ROOT/docs/scenes/balls.csv" . => 0
        $ steward run break.json --out break.jsonl => 0 turns, all bodies are slower than the scene's restBelow
        $ grep -o '"kind":"death"' break.jsonl | wc -l => 0 ^\\s*3$
        $ tr -s '[:space:]' ' ' < "ROOT/docs/scenes.md" => 0 `steward run break.json` pots three

        docs/scenes.md ```json { "name": "my-bowl" > my-bowl.json
        $ steward run my-bowl.json --seed 7 => 0 turns, all bodies are slower than the scene's restBelow
        $ tr -s '[:space:]' ' ' < "ROOT/docs/scenes.md" => 0 to rest, as `steward run my-bowl.json --seed 7` does
        """;

    private static final String LONG_PLAYS = """
        README.md ```python > bot.py
        README.md $ steward match --bot 'me=python3 bot.py' --bot builtin:racer => 0 RACE_END
        README.md $ steward replay match.jsonl --turn 57 => 0 57
        docs/replays.md $ steward replay match.jsonl --impacts => 0 impulse
        docs/replays.md $ steward replay match.jsonl --frames --player 0 => 0 ^\\{"type":"setup",
        docs/watching.md $ steward replay match.jsonl --view match.html => 0
        $ wc -c < match.html => 0 \\d{5}
        docs/debugging.md $ steward feed match.jsonl --player racer -- builtin:veteran => 1 differs

        $ cp "ROOT/src/test/resources/codingame/pilot.py" other.py => 0
        $ printf '#!/bin/sh\\nexec python3 other.py\\n' > mine && chmod +x mine && cp mine a.out => 0
        docs/protocol.md $ steward match --bot codingame:./a.out --bot builtin:racer => 0 RACE_END
        docs/compatibility.md $ steward referee -p1 ./mine => 0
        $ test -f game.json && steward replay match.jsonl --verify => 0 verified:

        docs/scenes.md $ steward scene walled-race > my-scene.json => 0
        docs/scenes.md $ steward explain my-scene.json => 0 "scene":"walled-race"

        $ printf '#!/bin/sh\\ntest -z "$AN_OPINION$A_PASSWORD" || exit 3\\nexit 4\\n' > mine && chmod +x mine => 0
        $ grep '^ *env -i .* steward match' "ROOT/docs/security.md" > hidden.sh => 0
        $ sed 's/.* steward match/steward match/' hidden.sh > open.sh => 0
        $ AN_OPINION=own sh hidden.sh => 0 exited with status 4
        $ AN_OPINION=own sh open.sh => 0 exited with status 3
        $ A_PASSWORD=secret sh open.sh => 0 exited with status 4

        $ sh "ROOT/src/examples/shell/league-of-five.sh" > said.txt => 0
        $ grep -o 'thrust[0-9]* ' said.txt | sort -u | tr -d 'thrus\\n' => 0 ^100 120 140 160 200
        $ cat said.txt => 0 20 games of mad-pod-racing
        """;

    @TempDir
    private Path folder;
    private PageShell shell;

    @BeforeEach
    void prepare() throws IOException {
        shell = new PageShell(folder, """
            case "$1 $*" in
              *--time-factor*) ;;
              match*|referee*|play*) set -- "$@" --time-factor 100 ;;
            esac
            """);
    }

    static Stream<String> plays() {
        return Stream.of(PLAYS.split("\n\n"));
    }

    static Stream<String> longPlays() {
        return Stream.of(LONG_PLAYS.split("\n\n"));
    }

    @ParameterizedTest
    @MethodSource("plays")
    void aPlayIsAsItIsShown(String steps) throws IOException, InterruptedException {
        play(steps);
    }

    @ParameterizedTest
    @MethodSource("longPlays")
    @Tag("campaign")
    void aLongPlayIsAsItIsShown(String steps) throws IOException, InterruptedException {
        play(steps);
    }

    private void play(String steps) throws IOException, InterruptedException {
        if (steps.matches("(?s).*(python3|league-of-five).*")) {
            PageShell.need("python3");
        }
        for (String line : steps.lines().toList()) {
            Matcher step = STEP.matcher(line);
            assertTrue(step.matches(), line);
            if (step.group(4) != null) {
                String begin = step.group(3) == null ? "" : Pattern.quote(step.group(3));
                Files.writeString(folder.resolve(step.group(4)), PageShell.fenced(step.group(1), "```" + step.group(2)
                    + "\\R(" + begin + ".*?)```", 0));
                continue;
            }
            String call = step.group(1) != null ? PageShell.line(step.group(1), step.group(5))
                : step.group(5).replace("ROOT", ROOT).replace("JAVA", JAVA);
            String said = shell.runLine(Integer.parseInt(step.group(6)), call);
            String expected = step.group(7).replace("RACE_END", RACE_END);
            assertTrue(Pattern.compile(expected).matcher(said).find(), () -> line + "\n" + said);
        }
    }

    @Test
    void aLineThatFailsIsFound() {
        for (String line : List.of("README.md $ steward replay match.jsonl --verify => 0", "$ true => 0 no such words",
                "README.md $ steward nothing => 0")) {
            assertThrows(AssertionError.class, () -> play(line), line);
        }
    }
}
