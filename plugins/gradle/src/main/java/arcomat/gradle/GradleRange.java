package arcomat.gradle;

import org.gradle.api.GradleException;
import org.gradle.util.GradleVersion;

/** The versions of Gradle that the plugin works with. */
final class GradleRange {
    /** The oldest that it is tried with, and the oldest that can be had from Maven Central. */
    private static final GradleVersion LEAST = GradleVersion.version("7.6");

    private GradleRange() {}

    /**
     * Refuses what is older, before something is missing in the middle of a build.
     *
     * @throws GradleException where it is
     */
    static void require(GradleVersion version) {
        if (version.getBaseVersion().compareTo(LEAST) < 0) {
            throw new GradleException(
                    "the plugin 'arcomat' needs Gradle "
                            + LEAST.getVersion()
                            + " or newer, and this is "
                            + version.getVersion()
                            + "; './gradlew wrapper --gradle-version "
                            + LEAST.getVersion()
                            + "' brings it");
        }
    }
}
