package arcomat;

import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.core.domain.InstanceofCheck;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaCodeUnit;

import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Collectors;

/**
 * A sum is taken apart by its {@code match}, for which the compiler asks a case of every form; a
 * chain of questions compiles with a form more, and lets that one fall through. Up to two questions
 * are questions.
 */
class SumsTest {
    /** Once for all cases: it takes seconds. */
    @BeforeAll
    static void readClasses() {
        assertThat(House.rooms()).isNotEmpty();
    }

    /** Forms that one method may ask about. */
    private static final int QUESTIONS = 2;

    @Test
    void noMethodTakesASumApartByAChainOfQuestions() {
        Map<JavaClass, Set<JavaClass>> sums = sums();
        List<String> chains = new ArrayList<>();
        for (JavaClass each : House.CLASSES) {
            for (JavaCodeUnit method : each.getCodeUnits()) {
                Set<JavaClass> asked =
                        method.getInstanceofChecks().stream()
                                .map(InstanceofCheck::getRawType)
                                .collect(Collectors.toSet());
                sums.forEach(
                        (sum, forms) -> {
                            long count = asked.stream().filter(forms::contains).count();
                            if (count > QUESTIONS) {
                                chains.add(
                                        method.getFullName()
                                                + " asks about "
                                                + count
                                                + " forms of "
                                                + sum.getSimpleName());
                            }
                        });
            }
        }
        assertThat(chains).isEmpty();
    }

    private static Map<JavaClass, Set<JavaClass>> sums() {
        Map<JavaClass, Set<JavaClass>> sums =
                new TreeMap<>(Comparator.comparing(JavaClass::getName));
        for (JavaClass each : House.CLASSES) {
            if (each.isInterface() && each.reflect().isSealed()) {
                sums.put(each, each.getAllSubclasses());
            }
        }
        return sums;
    }
}
