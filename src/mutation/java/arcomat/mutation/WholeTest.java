package arcomat.mutation;

import static org.junit.platform.engine.discovery.DiscoverySelectors.selectUniqueId;

import org.junit.platform.engine.TestExecutionResult;
import org.junit.platform.launcher.Launcher;
import org.junit.platform.launcher.TestExecutionListener;
import org.junit.platform.launcher.TestIdentifier;
import org.junit.platform.launcher.core.LauncherDiscoveryRequestBuilder;
import org.pitest.testapi.AbstractTestUnit;
import org.pitest.testapi.Description;
import org.pitest.testapi.ResultCollector;

import java.util.ArrayList;
import java.util.List;

/** A test method with all that it makes; it fails with the first of these that fails. */
final class WholeTest extends AbstractTestUnit {

    private final Launcher launcher;
    private final String id;

    WholeTest(Launcher launcher, Class<?> testClass, TestIdentifier method) {
        super(new Description(method.getUniqueId(), testClass));
        this.launcher = launcher;
        this.id = method.getUniqueId();
    }

    @Override
    public void execute(ResultCollector results) {
        var failures = new Failures(new ArrayList<>());
        results.notifyStart(getDescription());
        launcher.execute(
                LauncherDiscoveryRequestBuilder.request()
                        .selectors(selectUniqueId(id))
                        .configurationParameter(
                                "junit.jupiter.extensions.autodetection.enabled", "true")
                        .build(),
                failures);
        failures.seen.stream()
                .findFirst()
                .ifPresentOrElse(
                        failure -> results.notifyEnd(getDescription(), failure),
                        () -> results.notifyEnd(getDescription()));
    }

    private record Failures(List<Throwable> seen) implements TestExecutionListener {

        @Override
        public void executionFinished(TestIdentifier test, TestExecutionResult result) {
            if (result.getStatus() == TestExecutionResult.Status.FAILED) {
                seen.add(result.getThrowable().orElseGet(AssertionError::new));
            }
        }
    }
}
