package arcomat.gradle;

import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.gradle.api.GradleException;
import org.gradle.util.GradleVersion;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Distributions of other versions are not at hand: what is said of them can be tried. */
class GradleRangeTest {
    @ParameterizedTest
    @ValueSource(strings = {"8.8", "8.8-rc-1", "8.14.3", "9.0"})
    void worksWith(String version) {
        assertThatCode(() -> GradleRange.require(GradleVersion.version(version)))
                .doesNotThrowAnyException();
    }

    @Test
    void refusesWhatIsOlder() {
        assertThatThrownBy(() -> GradleRange.require(GradleVersion.version("8.7")))
                .isInstanceOf(GradleException.class)
                .hasMessage(
                        "the plugin 'arcomat' needs Gradle 8.8 or newer, and this is 8.7;"
                                + " './gradlew wrapper --gradle-version 8.8' brings it");
    }
}
