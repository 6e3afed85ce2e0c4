package steward.build;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.concurrent.ConcurrentHashMap;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.platform.engine.TestExecutionResult;
import org.junit.platform.launcher.TestExecutionListener;
import org.junit.platform.launcher.TestIdentifier;
import org.junit.platform.launcher.TestPlan;

/**
 * Reasons of skipped tests, counted. They are written to the file that the system property {@code steward.skipped}
 * names, one a line, the most frequent first; the build prints it. JUnit finds this listener by
 * {@link java.util.ServiceLoader}. A skipped class counts with all its tests that have not run.
 */
public final class SkippedTests implements TestExecutionListener {
    private final Map<String, String> reasons = new ConcurrentHashMap<>();
    private final Set<String> finished = ConcurrentHashMap.newKeySet();
    private volatile TestPlan plan;

    @Override
    public void testPlanExecutionStarted(TestPlan started) {
        plan = started;
    }

    @Override
    public void executionSkipped(TestIdentifier test, String reason) {
        skip(test, reason);
    }

    @Override
    public void executionFinished(TestIdentifier test, TestExecutionResult result) {
        if (result.getStatus() == TestExecutionResult.Status.ABORTED) {
            skip(test, result.getThrowable().map(Throwable::getMessage).orElse(""));
        } else if (test.isTest()) {
            finished.add(test.getUniqueId());
        }
    }

    private void skip(TestIdentifier skipped, String reason) {
        Stream.concat(Stream.of(skipped), plan.getDescendants(skipped).stream())
            .filter(each -> each.isTest() || plan.getChildren(each).isEmpty())
            .filter(each -> !finished.contains(each.getUniqueId()))
            .forEach(each -> reasons.putIfAbsent(each.getUniqueId(), normalized(reason)));
    }

    @Override
    public void testPlanExecutionFinished(TestPlan ended) {
        String file = System.getProperty("steward.skipped");
        if (file != null) {
            try {
                Files.createDirectories(Path.of(file).toAbsolutePath().getParent());
                Files.write(Path.of(file), lines());
            } catch (IOException problem) {
                throw new UncheckedIOException(problem);
            }
        }
    }

    /** Returns one line for each reason, with its count, the most frequent first, then by their letters. */
    List<String> lines() {
        Map<String, Integer> counts = new TreeMap<>();
        reasons.values().forEach(reason -> counts.merge(reason, 1, Integer::sum));
        return counts.entrySet().stream().sorted(Map.Entry.<String, Integer>comparingByValue().reversed())
            .map(each -> each.getValue() + ": " + each.getKey()).collect(Collectors.toList());
    }

    /** Returns a reason without the words that JUnit and tests put before it, so that equal reasons are equal texts. */
    private static String normalized(String reason) {
        String text = reason == null ? "" : reason.strip().replaceFirst("^Assumption failed: ", "")
            .replaceFirst("^System property .* ==> ", "").replaceFirst("^skipped: ", "")
            .replaceFirst("^there is no ", "no ").replace(" on the PATH", "");
        return text.isEmpty() || text.startsWith("Assumption failed") ? "a test that does not say why" : text;
    }
}
