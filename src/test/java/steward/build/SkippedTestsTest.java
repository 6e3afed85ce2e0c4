package steward.build;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.platform.engine.EngineDiscoveryRequest;
import org.junit.platform.engine.EngineExecutionListener;
import org.junit.platform.engine.ExecutionRequest;
import org.junit.platform.engine.TestDescriptor;
import org.junit.platform.engine.TestEngine;
import org.junit.platform.engine.TestExecutionResult;
import org.junit.platform.engine.UniqueId;
import org.junit.platform.engine.support.descriptor.AbstractTestDescriptor;
import org.junit.platform.engine.support.descriptor.EngineDescriptor;
import org.junit.platform.launcher.core.LauncherConfig;
import org.junit.platform.launcher.core.LauncherDiscoveryRequestBuilder;
import org.junit.platform.launcher.core.LauncherFactory;

class SkippedTestsTest {

    /** Engine with two classes of three tests each; of the first, one passes and two are skipped; all of the second. */
    private static final class Sample implements TestEngine {

        @Override
        public String getId() {
            return "sample";
        }

        @Override
        public TestDescriptor discover(EngineDiscoveryRequest request, UniqueId id) {
            TestDescriptor engine = new EngineDescriptor(id, "sample");
            for (String type : List.of("some", "none")) {
                TestDescriptor parent = descriptor(id.append("class", type), TestDescriptor.Type.CONTAINER);
                engine.addChild(parent);
                for (String test : List.of("a", "b", "c")) {
                    parent.addChild(descriptor(parent.getUniqueId().append("test", test), TestDescriptor.Type.TEST));
                }
            }
            return engine;
        }

        private static TestDescriptor descriptor(UniqueId id, TestDescriptor.Type type) {
            return new AbstractTestDescriptor(id, id.getLastSegment().getValue()) {
                @Override
                public Type getType() {
                    return type;
                }
            };
        }

        @Override
        public void execute(ExecutionRequest request) {
            EngineExecutionListener listener = request.getEngineExecutionListener();
            TestDescriptor engine = request.getRootTestDescriptor();
            List<? extends TestDescriptor> classes = List.copyOf(engine.getChildren());
            List<? extends TestDescriptor> tests = List.copyOf(classes.get(0).getChildren());
            listener.executionStarted(engine);
            listener.executionStarted(classes.get(0));
            finish(listener, tests.get(0), TestExecutionResult.successful());
            finish(listener, tests.get(1), aborted("Assumption failed: skipped: there is no unicorn on the PATH"));
            listener.executionSkipped(tests.get(2), "System property [horn] does not exist ==> no unicorn");
            listener.executionFinished(classes.get(0), TestExecutionResult.successful());
            finish(listener, classes.get(1), aborted("Assumption failed: no folder of wands, -Pwands=FOLDER"));
            listener.executionFinished(engine, TestExecutionResult.successful());
        }

        private static TestExecutionResult aborted(String message) {
            return TestExecutionResult.aborted(new IllegalStateException(message));
        }

        private static void finish(EngineExecutionListener listener, TestDescriptor test, TestExecutionResult result) {
            listener.executionStarted(test);
            listener.executionFinished(test, result);
        }
    }

    @Test
    void equalReasonsAreCountedAlsoOfAWholeClass() {
        SkippedTests listener = new SkippedTests();
        LauncherFactory.create(LauncherConfig.builder().enableTestEngineAutoRegistration(false)
            .enableTestExecutionListenerAutoRegistration(false).addTestEngines(new Sample()).build())
            .execute(LauncherDiscoveryRequestBuilder.request().build(), listener);

        assertEquals(List.of("3: no folder of wands, -Pwands=FOLDER", "2: no unicorn"), listener.lines());
    }
}
