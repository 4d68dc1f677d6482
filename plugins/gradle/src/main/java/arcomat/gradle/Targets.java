package arcomat.gradle;

import org.gradle.api.InvalidUserDataException;

import java.util.List;

/** What a build may ask code for by name. */
final class Targets {
    static final String JVM = "jvm";
    static final String LEJOS = "lejos";

    private static final List<String> ALL = List.of(JVM, LEJOS);

    private Targets() {}

    /** Whether a build wants a target; refuses names that are none. */
    static boolean contain(List<String> wanted, String target) {
        for (String each : wanted) {
            if (!ALL.contains(each)) {
                throw new InvalidUserDataException(
                        "arcomat.targets names '"
                                + each
                                + "', and there are "
                                + String.join(" and ", ALL)
                                + "; for templates of your own register a task of type"
                                + " GenerateArc");
            }
        }
        return wanted.contains(target);
    }
}
