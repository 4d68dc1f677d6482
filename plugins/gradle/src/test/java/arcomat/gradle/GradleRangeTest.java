package arcomat.gradle;

import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.gradle.api.GradleException;
import org.gradle.util.GradleVersion;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What is said of versions; {@link OldestGradleTest} tries the oldest one. */
class GradleRangeTest {
    @ParameterizedTest
    @ValueSource(strings = {"7.6", "7.6-rc-1", "8.8", "8.14.3", "9.0"})
    void worksWith(String version) {
        assertThatCode(() -> GradleRange.require(GradleVersion.version(version)))
                .doesNotThrowAnyException();
    }

    @Test
    void refusesWhatIsOlder() {
        assertThatThrownBy(() -> GradleRange.require(GradleVersion.version("7.5.1")))
                .isInstanceOf(GradleException.class)
                .hasMessage(
                        "the plugin 'arcomat' needs Gradle 7.6 or newer, and this is 7.5.1;"
                                + " './gradlew wrapper --gradle-version 7.6' brings it");
    }
}
