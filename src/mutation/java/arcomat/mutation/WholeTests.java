package arcomat.mutation;

import static org.junit.platform.engine.discovery.DiscoverySelectors.selectClass;

import org.junit.platform.engine.support.descriptor.MethodSource;
import org.junit.platform.launcher.Launcher;
import org.junit.platform.launcher.TagFilter;
import org.junit.platform.launcher.TestIdentifier;
import org.junit.platform.launcher.core.LauncherDiscoveryRequestBuilder;
import org.junit.platform.launcher.core.LauncherFactory;
import org.pitest.classinfo.ClassByteArraySource;
import org.pitest.help.PitHelpError;
import org.pitest.testapi.Configuration;
import org.pitest.testapi.TestGroupConfig;
import org.pitest.testapi.TestPluginFactory;
import org.pitest.testapi.TestSuiteFinder;
import org.pitest.testapi.TestUnit;
import org.pitest.testapi.TestUnitExecutionListener;
import org.pitest.testapi.TestUnitFinder;

import java.util.Collection;
import java.util.List;
import java.util.Optional;

/**
 * The tests of PIT are the methods, of JUnit and of jqwik, and are found without running them. A
 * method that makes a test of each line of a file is one test: PIT's own plugin runs them all to
 * learn their names, and has the file read again for each line.
 */
public final class WholeTests implements TestPluginFactory {

    @Override
    public String description() {
        return "Tests are methods";
    }

    @Override
    public String name() {
        return "methods";
    }

    @Override
    public Configuration createTestFrameworkConfiguration(
            TestGroupConfig groups,
            ClassByteArraySource source,
            Collection<String> excludedRunners,
            Collection<String> includedTestMethods) {
        return new Methods(new MethodFinder(LauncherFactory.create(), groups.getExcludedGroups()));
    }

    private record Methods(TestUnitFinder testUnitFinder) implements Configuration {

        @Override
        public TestSuiteFinder testSuiteFinder() {
            return testClass -> List.of();
        }

        @Override
        public Optional<PitHelpError> verifyEnvironment() {
            return Optional.empty();
        }
    }

    private record MethodFinder(Launcher launcher, List<String> excludedTags)
            implements TestUnitFinder {

        @Override
        public List<TestUnit> findTestUnits(
                Class<?> testClass, TestUnitExecutionListener listener) {
            return testClass.getEnclosingClass() == null ? tests(testClass) : List.of();
        }

        private List<TestUnit> tests(Class<?> testClass) {
            var request =
                    LauncherDiscoveryRequestBuilder.request()
                            .selectors(selectClass(testClass))
                            .filters(TagFilter.excludeTags(excludedTags))
                            .build();
            var plan = launcher.discover(request);
            return plan.getRoots().stream()
                    .flatMap(root -> plan.getDescendants(root).stream())
                    .filter(MethodFinder::isMethod)
                    .<TestUnit>map(method -> new WholeTest(launcher, testClass, method))
                    .toList();
        }

        private static boolean isMethod(TestIdentifier found) {
            return found.getSource().filter(MethodSource.class::isInstance).isPresent();
        }
    }
}
