package steward.replay.page;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import steward.live.LiveRecording;
import steward.live.LiveServer;

/**
 * Script time of the frames of the page of a match while it plays at the usual speed, frames a second, and how far the
 * page of a live match is behind.
 */
public final class PageBench {

    private static final int SECONDS = 8;
    /** Turns a second at which a match is played live. */
    private static final int[] PACES = {5, 20, 100};

    private PageBench() {
    }

    /** Prints a line for a pod race and for matches of more and more bodies, then one for each pace. */
    public static void main(String[] args) throws IOException, InterruptedException {
        Path folder = Files.createTempDirectory("steward-page-bench");
        try (PageTestBrowser browser = PageTestBrowser.start()) {
            browser.size(1440, 900);
            browser.prefer(true, false);
            System.out.println("Script in ms            frame: median  90%   most    turn begins: median  90%   most   "
                + "frames/s");
            PageTestPages pages = new PageTestPages(folder);
            byte[] race = PageTestRaces.play(PageTestRaces.scene("mad-pod-racing"), 3);
            browser.open(pages.page(race, "Race"), "#t=1");
            measure(browser, "pod race");
            for (int bodies : new int[] {50, 500}) {
                browser.open(pages.live("Bodies"), "");
                PageTestCrowd.lines(bodies).forEach(line -> browser.run("steward.addTurn(arguments[0])", line));
                measure(browser, bodies + " bodies");
            }
            System.out.println();
            System.out.println("Turns behind a live match, by what the page has: median   most; by what was played: "
                + "median   most");
            for (int pace : PACES) {
                live(browser, race, pace);
            }
        } finally {
            try (Stream<Path> files = Files.walk(folder)) {
                files.sorted(Comparator.reverseOrder()).forEach(file -> file.toFile().delete());
            }
        }
    }

    @SuppressWarnings("unchecked")
    private static void measure(PageTestBrowser browser, String name) throws InterruptedException {
        browser.run("""
            const frames = window.frames = [];
            steward.onFrame((ms, turn) => frames.push([ms, turn]));
            steward.seek(4);
            steward.play();
            """);
        TimeUnit.SECONDS.sleep(SECONDS);
        List<List<Number>> frames = (List<List<Number>>) browser.run("steward.onFrame(null); return window.frames");
        List<Double> within = new ArrayList<>();
        List<Double> begins = new ArrayList<>();
        for (int k = 1; k < frames.size(); k++) {
            boolean isNew = frames.get(k).get(1).intValue() != frames.get(k - 1).get(1).intValue();
            (isNew ? begins : within).add(frames.get(k).get(0).doubleValue());
        }
        System.out.printf(Locale.ROOT, "%-22s %15.2f %6.2f %6.2f %19.2f %6.2f %6.2f %10.1f%n", name,
            at(within, 0.5), at(within, 0.9), at(within, 1), at(begins, 0.5), at(begins, 0.9), at(begins, 1),
            frames.size() / (double) SECONDS);
    }

    private static double at(List<Double> values, double share) {
        List<Double> sorted = values.stream().sorted().toList();
        return sorted.isEmpty() ? Double.NaN : sorted.get((int) (share * (sorted.size() - 1)));
    }

    @SuppressWarnings("unchecked")
    private static void live(PageTestBrowser browser, byte[] replay, int pace)
            throws IOException, InterruptedException {
        List<String> lines = new String(replay, StandardCharsets.UTF_8).lines().collect(Collectors.toList());
        LiveRecording recording = new LiveRecording();
        AtomicInteger played = new AtomicInteger();
        ScheduledExecutorService referee = Executors.newSingleThreadScheduledExecutor();
        List<Double> byPlayed = new ArrayList<>();
        try (LiveServer server = LiveServer.start(null, 0, 1, "Live", recording, PageExtras.NONE)) {
            browser.go(server.address().toString());
            write(recording, lines.get(0));
            browser.await("the match does not begin", () -> browser.is("document.querySelector('#scores .score')"));
            browser.run("""
                const behind = window.behind = [];
                const look = () => {
                  behind.push(steward.lastTurn() - steward.time());
                  requestAnimationFrame(() => setTimeout(look));
                };
                look();
                """);
            referee.scheduleAtFixedRate(() -> {
                if (played.get() < lines.size() - 2) {
                    write(recording, lines.get(played.incrementAndGet()));
                }
            }, 0, 1_000_000 / pace, TimeUnit.MICROSECONDS);
            while (played.get() < Math.min(lines.size() - 2, SECONDS * pace)) {
                int before = played.get();
                byPlayed.add(before - browser.number("steward.time()"));
            }
            List<Double> byPage = ((List<Number>) browser.run("return window.behind")).stream()
                .map(Number::doubleValue).toList();
            System.out.printf(Locale.ROOT, "%3d turns a second %37.2f %6.2f %29.2f %6.2f%n", pace, at(byPage, 0.5),
                at(byPage, 1), at(byPlayed, 0.5), at(byPlayed, 1));
        } finally {
            referee.shutdownNow();
            recording.close();
        }
    }

    private static void write(LiveRecording recording, String line) {
        byte[] bytes = (line + "\n").getBytes(StandardCharsets.UTF_8);
        recording.write(bytes, 0, bytes.length);
    }
}
