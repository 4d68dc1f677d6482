package arcomat.testing;

import org.junit.jupiter.api.extension.ConditionEvaluationResult;
import org.junit.jupiter.api.extension.DynamicTestInvocationContext;
import org.junit.jupiter.api.extension.ExecutionCondition;
import org.junit.jupiter.api.extension.ExtensionContext;
import org.junit.jupiter.api.extension.InvocationInterceptor;
import org.opentest4j.TestAbortedException;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * Chooses among the cases of parameterized and dynamic tests.
 *
 * <p>The system property {@code data} leaves only cases whose names contain it. A method with the
 * tag {@code some-slow} has cases of both tiers: those that a line of the resource {@code
 * slow-cases.txt} names, as {@code TranscriptTest world.txt}, without the number of a case, run
 * where the system property {@code tier} is {@code slow}; the others run elsewhere.
 */
public final class ChosenCases implements ExecutionCondition, InvocationInterceptor {
    private static final String CHOSEN = System.getProperty("data", "");
    private static final boolean IS_SLOW = System.getProperty("tier", "").equals("slow");
    private static final Set<String> SLOW = slowCases();

    private static Set<String> slowCases() {
        try (InputStream list = ChosenCases.class.getResourceAsStream("/slow-cases.txt")) {
            return list == null
                    ? Set.of()
                    : new String(list.readAllBytes(), StandardCharsets.UTF_8)
                            .lines()
                            .collect(Collectors.toSet());
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    @Override
    public ConditionEvaluationResult evaluateExecutionCondition(ExtensionContext context) {
        return context.getUniqueId().contains("[test-template-invocation:")
                ? reasonToSkip(context)
                        .map(ConditionEvaluationResult::disabled)
                        .orElse(ConditionEvaluationResult.enabled(null))
                : ConditionEvaluationResult.enabled(null);
    }

    @Override
    public void interceptDynamicTest(
            Invocation<Void> invocation,
            DynamicTestInvocationContext dynamic,
            ExtensionContext context)
            throws Throwable {
        Optional<String> reason = reasonToSkip(context);
        if (reason.isPresent()) {
            invocation.skip();
            throw new TestAbortedException(reason.get());
        }
        invocation.proceed();
    }

    private static Optional<String> reasonToSkip(ExtensionContext test) {
        String name = test.getDisplayName();
        if (!name.contains(CHOSEN)) {
            return Optional.of("only " + CHOSEN + " was asked for");
        }
        String line = className(test) + " " + name.replaceFirst("^\\[\\d+\\] ", "");
        if (isOfBothTiers(test) && SLOW.contains(line) != IS_SLOW) {
            return Optional.of(IS_SLOW ? "runs by test" : "runs by slowTest");
        }
        return Optional.empty();
    }

    /** Returns the simple name of the test class; of a dynamic test only the unique id tells it. */
    private static String className(ExtensionContext test) {
        return test.getUniqueId().replaceFirst(".*\\[class:(?:[^]]*\\.)?([^].]+)\\].*", "$1");
    }

    /** A dynamic test has no tags itself. */
    private static boolean isOfBothTiers(ExtensionContext test) {
        return test.getTags().contains("some-slow")
                || test.getParent().map(ChosenCases::isOfBothTiers).orElse(false);
    }
}
