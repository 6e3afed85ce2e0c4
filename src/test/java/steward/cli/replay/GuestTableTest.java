package steward.cli.replay;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import steward.cli.Cli;

/** The turns of a guest, which have no bodies: who said what, and what happened. */
class GuestTableTest {

    @TempDir
    private Path folder;

    @Test
    void turnsWithoutBodiesHaveTheirNumbersAndAnswers() throws IOException {
        Path replay = Files.writeString(folder.resolve("x.jsonl"), """
            {"type":"steward-replay","format":3,"angles":"correctly-rounded","game":"guest","seed":"3","players":[\
            {"name":"one","bot":"codingame:a","protocol":"codingame"},\
            {"name":"two","bot":"codingame:b","protocol":"codingame"}],"timeFactor":1,\
            "scene":{"name":"small","game":"guest","players":2,"referee":{"command":["none"]}},\
            "drawing":{"field":{"x":0,"y":0,"width":1600,"height":900},"walls":[],"zones":[],"bodies":[]},\
            "start":{"state":{"bodies":[],"asked":1,"said":[]},"hash":"0000000000000001"},\
            "headerHash":"0000000000000001"}
            {"type":"turn","turn":1,"commands":[null,{"lines":["WAIT","AND SEE"]}],"outcome":{"state":{"bodies":[],\
            "said":[]},"hash":"0000000000000002"},"turnHash":"0000000000000002"}
            {"type":"turn","turn":2,"commands":[null,null],"faults":["no answer",null],"outcome":{"events":[\
            {"kind":"mark","time":1,"x":800,"y":450,"text":"a lost"}],"state":{"bodies":[],"said":[]},\
            "hash":"0000000000000003"},"turnHash":"0000000000000003"}
            """);
        String out = Cli.run("replay", replay.toString()).out();
        assertTrue(out.contains("\n   1  two: WAIT, AND SEE\n   2  a lost\n   2  one failed: no answer\n"), out);
        assertTrue(!Cli.run("replay", replay.toString(), "--quiet").out().contains("WAIT"), out);
        for (String bodies : List.of("--map", "--impacts", "--impacts --json", "--picture " + folder + "/x.svg")) {
            Cli.run(("replay " + replay + " " + bodies).split(" ")).assertRefused(bodies.split(" ")[0]
                + ": found the scene \"small\", which has a referee of its own, expected a game that Steward computes");
        }
    }
}
