package steward.hostile;

import java.io.IOException;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import steward.bot.command.ProgramFinder;
import steward.bot.isolation.SandboxLevel;
import steward.bot.isolation.SandboxSupport;
import steward.cli.Cli;
import steward.cli.league.BrokenRows;
import steward.cli.machines.ForgedGames;
import steward.live.LiveRecording;
import steward.live.LiveServer;
import steward.machines.serve.HostileWorker.Way;
import steward.replay.page.PageExtras;
import tools.jackson.databind.JsonNode;

/** Attacks on what is stored, served and shared: each is tried, and says what became of it. */
final class Guards {

    private static final int VIEWERS = LiveServer.USUAL_VIEWERS;
    private static final int MEGABYTE = 1 << 20;
    private static final int MOST_MEGABYTES = 50;
    private static final long PATIENCE_MS = 60_000;

    private final Path folder;

    /** @param folder for files, empty */
    Guards(Path folder) {
        this.folder = folder;
    }

    private interface Attack {
        String found() throws IOException, InterruptedException;
    }

    /** Tries all; what was found by what was tried: it begins with "held" where nothing came of it. */
    Map<String, String> run() throws IOException, InterruptedException {
        Map<String, Attack> attacks = new LinkedHashMap<>();
        attacks.put("takes all " + VIEWERS + " places of a live page and reads nothing", this::viewers);
        attacks.put("says in a signed replay that it was played at `strict`", this::level);
        attacks.put("damages 20 values and rows of a league's database", this::rows);
        attacks.put("writes bytes that are not UTF-8 into a scene", this::bytes);
        for (SandboxLevel level : List.of(SandboxLevel.LIGHT, SandboxLevel.STRICT)) {
            if (SandboxSupport.problem(level) == null && ProgramFinder.find("cc") != null) {
                attacks.put("computes on 16 processes while its opponent is asked, at `" + level.word() + "`",
                    () -> burner(level, "hogs"));
                attacks.put("computes in four chains of processes of 2 ms while its opponent is asked, at `"
                    + level.word() + "`", () -> burner(level, "chain-4-2"));
            }
        }
        if (SandboxSupport.problem(SandboxLevel.STRICT) == null) {
            attacks.put("plays in a league at `strict` and looks for its files and other entrants' programs",
                this::spy);
        }
        Map<String, Way> ways = Map.of("reports forged states", Way.STATES, "changes commands", Way.COMMANDS,
            "answers for bots", Way.ANSWERS);
        ways.keySet().stream().sorted().forEach(what -> attacks.put(what + " as a worker beside two honest ones", () ->
            forger(ways.get(what))));
        Map<String, String> found = new LinkedHashMap<>();
        for (Map.Entry<String, Attack> each : attacks.entrySet()) {
            found.put(each.getKey(), each.getValue().found());
        }
        return found;
    }

    private static String held(boolean held, String otherwise) {
        return held ? "held" : "succeeds: " + otherwise;
    }

    /** The memory of this process is that of the server: clients are sockets whose buffers the system has. */
    private String viewers() throws IOException, InterruptedException {
        LiveRecording recording = new LiveRecording();
        byte[] line = ("x".repeat(MEGABYTE) + "\n").getBytes(StandardCharsets.US_ASCII);
        List<Socket> clients = new ArrayList<>();
        try (LiveServer server = LiveServer.start(null, 0, VIEWERS, "b", recording, PageExtras.NONE)) {
            for (int k = 0; k < 8; k++) {
                recording.write(line, 0, line.length);
            }
            long before = kilobytes();
            for (int k = 0; k < VIEWERS; k++) {
                clients.add(feed(server));
            }
            clients.get(VIEWERS - 1).getInputStream().read();
            long used = (kilobytes() - before) / 1024;
            server.awaitDelivery(PATIENCE_MS, 0);
            clients.add(feed(server));
            byte[] answer = clients.get(VIEWERS).getInputStream().readNBytes(2000);
            boolean served = new String(answer, StandardCharsets.US_ASCII).contains("data: xxx");
            return held(served && used < MOST_MEGABYTES, "served " + served) + ", " + Math.max(1, used) + " MB";
        } finally {
            for (Socket client : clients) {
                client.close();
            }
        }
    }

    private static Socket feed(LiveServer server) throws IOException {
        Socket socket = new Socket(server.address().getHost(), server.address().getPort());
        socket.getOutputStream().write(("GET /feed HTTP/1.1\r\nHost: localhost:" + server.address().getPort()
            + "\r\n\r\n").getBytes(StandardCharsets.US_ASCII));
        return socket;
    }

    /** Resident memory of this process. */
    private static long kilobytes() throws IOException {
        return Files.readAllLines(Path.of("/proc/self/status")).stream().filter(line -> line.startsWith("VmRSS:"))
            .mapToLong(line -> Long.parseLong(line.replaceAll("\\D", ""))).findFirst().orElseThrow();
    }

    private String level() throws IOException {
        Path replay = folder.resolve("m.jsonl");
        Cli.run("key", "new", folder.resolve("k").toString()).done();
        Cli.run("match", "--scene", "duel", "--sandbox", "off", "--bot", "sh -c 'exit 0'", "--bot", "sh -c 'exit 0'",
            "--sign", folder.resolve("k").toString(), "--out", replay.toString());
        Files.writeString(replay, Files.readString(replay).replace("\"isolation\":\"off", "\"isolation\":\"strict"));
        Cli said = Cli.run("replay", replay.toString(), "--verify", "--signed-by", folder.resolve("k.pub").toString(),
            "--require", "strict");
        return held(said.status() == 1, said.out());
    }

    private String rows() throws IOException {
        BrokenRows rows = new BrokenRows(Files.createDirectory(folder.resolve("rows")), 1);
        for (int k = 0; k < 20; k++) {
            try {
                rows.check(k);
            } catch (AssertionError problem) {
                return held(false, problem.getMessage());
            }
        }
        return held(true, "");
    }

    private String bytes() throws IOException {
        Path scene = Files.write(folder.resolve("s.json"), new byte[] {'{', '\n', '"', (byte) 0xE9});
        Cli said = Cli.run("explain", scene.toString());
        return held(said.status() == 2 && said.err().contains(scene + ":2:2: "), said.err());
    }

    /** Held where no game counts that a single machine would not have played; one that answers for bots is named. */
    private String forger(Way way) throws IOException, InterruptedException {
        List<String> problems = ForgedGames.problems(Files.createDirectory(folder.resolve(way.name())), way);
        return held(problems.isEmpty(), String.join("; ", problems))
            + (way == Way.ANSWERS ? ": it is named, and `revoke --set-aside` takes its games away" : "");
    }

    /** Held is a burner that is stopped before the match is over, whose opponent answers every time. */
    private String burner(SandboxLevel level, String word) throws IOException, InterruptedException {
        Path hog = Files.createDirectories(folder.resolve(level.word())).resolve("hog");
        new ProcessBuilder("cc", "-O1", "-o", hog.toString(), "src/test/hostile/hog.c").inheritIO().start().waitFor();
        Cli said = Cli.run("match", "--scene", "duel", "--seed", "7", "--sandbox", level.word(), "--time-factor",
            "4", "--json", "--bot", hog + " " + word + " 0", "--bot", hog + " none 50");
        int from = said.json().path("players").path(0).path("heldFrom").asInt(0);
        JsonNode fault = said.json().path("players").path(1).path("fault");
        return held(from > 0 && fault.isNull(), "held from turn " + from + ", its opponent: " + fault);
    }

    /** The spy is outside the league's folder, as is the program of another entrant. It exits where it sees a file. */
    private String spy() throws IOException {
        Path league = folder.resolve("league");
        Path entrants = Files.createDirectories(folder.resolve("entrants"));
        Path other = Files.createDirectories(entrants.resolve("other")).resolve("honest.sh");
        Path spy = Files.createDirectories(entrants.resolve("spy")).resolve("spy.sh");
        Files.copy(Path.of("src/test/hostile/honest.sh"), other);
        Cli.run("league", "init", league.toString(), "--scene", "duel").done();
        Path settings = league.resolve("league.json");
        Files.writeString(settings, Files.readString(settings).replace("\"auto\"", "\"strict\""));
        Cli.run("league", "worker", "add", league.toString(), "one", "--out", league + "/token").done();
        Files.writeString(spy, "for file in " + league + "/* " + league + "/*/* " + other + "; do\n"
            + "  [ -e \"$file\" ] && { echo \"sees $file\" >&2; exit 77; }\ndone\n" + Files.readString(other));
        Cli.run("league", "add", league.toString(), "spy=sh " + spy).done();
        Cli.run("league", "add", league.toString(), "other=sh " + other).done();
        Cli run = Cli.run("league", "run", league.toString(), "--games", "4").done();
        Cli failed = Cli.run("league", "games", league.toString(), "--failed").done();
        long late = failed.out().lines().filter(line -> line.matches(" *\\d+ +\\d{4}-.*")).count();
        boolean looked = run.out().contains("4 games in this run") && late < 4;    // it looks before its first answer
        return held(looked && !failed.out().contains("sees ") && !failed.out().contains("status 77"), failed.out());
    }
}
