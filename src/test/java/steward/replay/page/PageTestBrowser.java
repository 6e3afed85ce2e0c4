package steward.replay.page;

import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Base64;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.BooleanSupplier;
import java.util.logging.Level;
import java.util.logging.Logger;
import java.util.stream.Stream;
import org.openqa.selenium.By;
import org.openqa.selenium.Dimension;
import org.openqa.selenium.chrome.ChromeDriver;
import org.openqa.selenium.chrome.ChromeDriverService;
import org.openqa.selenium.chrome.ChromeOptions;
import org.openqa.selenium.logging.LogType;
import org.openqa.selenium.logging.LoggingPreferences;
import steward.bot.command.ProgramFinder;

/**
 * A headless Chromium in which tests look at pages, through the page's own test hook {@code window.steward}. One serves
 * all classes of this JVM, one after another by its {@link #LOCK}; who is done with it closes it, and the next finds it
 * as new. It ends with the JVM.
 */
public final class PageTestBrowser implements AutoCloseable {

    /** Name of the lock of those who use it: {@code @ResourceLock}, beside the tag {@code browser}. */
    public static final String LOCK = "browser";

    private static final String BLANK = "about:blank";

    private static final Duration PATIENCE = Duration.ofSeconds(60);

    /** Warns of every Chromium newer than itself; kept here because loggers are only held weakly. */
    private static final Logger VERSION_FINDER = Logger.getLogger("org.openqa.selenium.devtools.CdpVersionFinder");

    private static final AtomicBoolean IN_USE = new AtomicBoolean();
    /** Chromium's own folder for temporary files, of which it leaves some behind. */
    private static final Path TEMPORARY = temporary();

    private final ChromeDriver driver = Started.DRIVER;

    /** The browser of this JVM, started by the first test that looks at a page. */
    private static final class Started {

        static final ChromeDriver DRIVER = driver(browser(), driverProgram());
        /** Size of the page that was set last. */
        static Dimension size;

        static {
            Runtime.getRuntime().addShutdownHook(new Thread(() -> {
                DRIVER.quit();
                delete(TEMPORARY);
            }));
        }
    }

    private static Path temporary() {
        try {
            return Files.createTempDirectory("steward-browser-");
        } catch (IOException problem) {
            throw new UncheckedIOException(problem);
        }
    }

    private static void delete(Path folder) {
        try (Stream<Path> files = Files.walk(folder)) {
            files.sorted(Comparator.reverseOrder()).forEach(file -> file.toFile().delete());
        } catch (IOException | UncheckedIOException gone) {
            folder.toFile().delete();                      // the browser was still tidying up
        }
    }

    private PageTestBrowser() {
        size(1280, 720);
    }

    private static ChromeDriver driver(Path browser, Path driverProgram) {
        VERSION_FINDER.setLevel(Level.SEVERE);
        LoggingPreferences logs = new LoggingPreferences();
        logs.enable(LogType.BROWSER, Level.ALL);
        logs.enable(LogType.PERFORMANCE, Level.ALL);
        ChromeOptions options = new ChromeOptions();
        options.setBinary(browser.toFile());
        options.addArguments("--headless", "--no-sandbox", "--disable-gpu", "--no-first-run",
            "--disable-background-networking", "--disable-component-update", "--disable-sync", "--disable-extensions",
            "--hide-scrollbars", "--force-device-scale-factor=1");
        options.setCapability("goog:loggingPrefs", logs);
        options.setExperimentalOption("perfLoggingPrefs", Map.of("enablePage", false));       // requests are asked for
        System.setProperty(ChromeDriverService.CHROME_DRIVER_EXE_PROPERTY, driverProgram.toString());
        System.setProperty(ChromeDriverService.CHROME_DRIVER_SILENT_OUTPUT_PROPERTY, "true");
        ChromeDriver driver = new ChromeDriver(new ChromeDriverService.Builder()
            .withEnvironment(Map.of("TMPDIR", TEMPORARY.toString())).build(), options);
        driver.manage().timeouts().scriptTimeout(PATIENCE).pageLoadTimeout(PATIENCE);
        return driver;
    }

    /** Hands out the browser; the test is skipped, saying so, where there is none or no driver for it. */
    public static PageTestBrowser start() {
        assumeTrue(browser() != null, "there is no chromium on the PATH");
        assumeTrue(driverProgram() != null, "there is no chromedriver on the PATH");
        if (!IN_USE.compareAndSet(false, true)) {
            throw new IllegalStateException("the browser is in use, or a test has not closed it");
        }
        try {
            return new PageTestBrowser();
        } catch (RuntimeException | Error problem) {
            IN_USE.set(false);
            throw problem;
        }
    }

    private static Path browser() {
        return find("chromium", "chromium-browser", "google-chrome");
    }

    private static Path driverProgram() {
        return find("chromedriver");
    }

    private static Path find(String... names) {
        return Stream.of(names).map(ProgramFinder::find).filter(Objects::nonNull).findFirst().orElse(null);
    }

    /** Opens a page from disk and waits until it is ready; the link, such as {@code #turn=57}, may be empty. */
    public void open(Path page, String link) {
        go(page.toUri() + link);
    }

    /** Opens a page from disk that has no script. */
    public void openPlain(Path page) {
        load(page.toUri().toString());
    }

    private void load(String address) {
        if (!BLANK.equals(driver.getCurrentUrl())) {
            driver.get(BLANK);                               // otherwise a change of the link alone loads nothing
        }
        logs(LogType.BROWSER);
        logs(LogType.PERFORMANCE);
        driver.get(address);
    }

    /** Opens an address and waits until the page is ready. */
    public void go(String address) {
        load(address);
        await("the page is not ready", () -> is("window.steward && window.steward.ready"));
    }

    /** The size of the page itself. */
    public void size(int width, int height) {
        Dimension wanted = new Dimension(width, height);
        if (wanted.equals(Started.size)) {
            return;
        }
        Started.size = wanted;
        driver.executeCdpCommand("Emulation.setDeviceMetricsOverride",
            Map.of("width", width, "height", height, "deviceScaleFactor", 1, "mobile", width < 500));
        driver.manage().window().setSize(wanted);
    }

    /** Sets the machine's preferences: light or dark, and whether motion is to be reduced. */
    public void prefer(boolean dark, boolean reducedMotion) {
        driver.executeCdpCommand("Emulation.setEmulatedMedia", Map.of("features", List.of(
            Map.of("name", "prefers-color-scheme", "value", dark ? "dark" : "light"),
            Map.of("name", "prefers-reduced-motion", "value", reducedMotion ? "reduce" : "no-preference"))));
    }

    public Object run(String script, Object... arguments) {
        return driver.executeScript(script, arguments);
    }

    public boolean is(String expression) {
        return Boolean.TRUE.equals(run("return Boolean(" + expression + ")"));
    }

    public double number(String expression) {
        return ((Number) run("return " + expression)).doubleValue();
    }

    public String text(String selector) {
        return (String) run("return document.querySelector(arguments[0]).innerText", selector);
    }

    void seek(int turn, double fraction) {
        run("steward.seek(arguments[0], arguments[1])", turn, fraction);
    }

    /** Draws a match from a time on at every so many turns, up to another time. */
    public void draw(double from, double to, double step) {
        run("for (let time = arguments[0]; time <= arguments[1]; time += arguments[2]) steward.seek(time)", from, to,
            step);
    }

    public void click(String selector) {
        driver.findElement(By.cssSelector(selector)).click();
    }

    void press(CharSequence keys) {
        driver.switchTo().activeElement().sendKeys(keys);
    }

    /** A finger that touches a place of the page and lets go. */
    void tap(double x, double y) {
        driver.executeCdpCommand("Input.dispatchTouchEvent", Map.of("type", "touchStart",
            "touchPoints", List.of(Map.of("x", x, "y", y))));
        driver.executeCdpCommand("Input.dispatchTouchEvent", Map.of("type", "touchEnd", "touchPoints", List.of()));
    }

    /** Returns the page's complaints in the console since it was opened. */
    public List<String> complaints() {
        return logs(LogType.BROWSER);
    }

    /** The addresses that were asked for since the page was opened, but for pages on disk and data within them. */
    public List<String> requests() {
        return logs(LogType.PERFORMANCE).stream().filter(line -> line.contains("\"Network.requestWillBeSent\""))
            .filter(line -> !line.contains("\"url\":\"file:") && !line.contains("\"url\":\"data:")).toList();
    }

    private List<String> logs(String type) {
        return driver.manage().logs().get(type).getAll().stream().map(entry -> entry.getMessage()).toList();
    }

    public void await(String otherwise, BooleanSupplier condition) {
        long end = System.nanoTime() + PATIENCE.toNanos();
        while (!condition.getAsBoolean()) {
            if (System.nanoTime() > end) {
                throw new AssertionError(otherwise);
            }
            try {
                Thread.sleep(20);
            } catch (InterruptedException e) {
                throw new AssertionError(otherwise, e);
            }
        }
    }

    /** Waits until the page has drawn what has changed, its size for one. */
    public void settle() {
        driver.executeAsyncScript("const done = arguments[0]; "
            + "requestAnimationFrame(() => requestAnimationFrame(() => requestAnimationFrame(() => done())))");
    }

    /** Turns to the page in the only frame of this page, and waits until it is ready. */
    public void enterFrame() {
        driver.switchTo().frame(0);
        await("the page in the frame is not ready", () -> is("window.steward && window.steward.ready"));
    }

    /** Turns back to the page that holds the frame. */
    public void leaveFrame() {
        driver.switchTo().defaultContent();
    }

    /** Turns the wheel over a place of the page that holds all others. */
    void wheel(int x, int y, int down) {
        driver.executeCdpCommand("Input.dispatchMouseEvent", Map.of("type", "mouseWheel", "x", x, "y", y, "deltaX", 0,
            "deltaY", down));
    }

    /** The number of windows that are open. */
    int windows() {
        return driver.getWindowHandles().size();
    }

    /** Turns to the window that was opened last, and waits until its page is ready. */
    public void lastWindow() {
        await("no window was opened", () -> windows() > 1);
        driver.switchTo().window(driver.getWindowHandles().stream().reduce((one, other) -> other).orElseThrow());
        await("the page of the window is not ready", () -> is("window.steward && window.steward.ready"));
    }

    /** Returns a picture of the window, as a PNG. */
    public byte[] screenshot() {
        return Base64.getDecoder().decode((String) driver.executeCdpCommand("Page.captureScreenshot",
            Map.of("format", "png", "optimizeForSpeed", true)).get("data"));
    }

    /** Closes the pages, and forgets what they stored and what was preferred. */
    @Override
    public void close() {
        try {
            List<String> windows = List.copyOf(driver.getWindowHandles());
            for (String window : windows.subList(1, windows.size())) {
                driver.switchTo().window(window).close();
            }
            driver.switchTo().window(windows.get(0)).get(BLANK);
            driver.executeCdpCommand("Emulation.setEmulatedMedia", Map.of("features", List.of()));
            driver.executeCdpCommand("Storage.clearDataForOrigin", Map.of("origin", "*", "storageTypes", "all"));
        } finally {
            IN_USE.set(false);
        }
    }
}
