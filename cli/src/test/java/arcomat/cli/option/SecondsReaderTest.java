package arcomat.cli.option;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import picocli.CommandLine.TypeConversionException;

import java.time.Duration;

class SecondsReaderTest {
    private final SecondsReader reader = new SecondsReader();

    @ParameterizedTest
    @CsvSource({
        "60, PT1M",
        "0.5, PT0.5S",
        ".5, PT0.5S",
        "1e-9, PT0.000000001S",
        "1.9999999999, PT1.999999999S",
        "9223372036.854775807, PT2562047H47M16.854775807S"
    })
    void aTimeIsRead(String written, Duration time) {
        assertThat(reader.convert(written)).isEqualTo(time);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "0",
                "-1",
                "-0.5",
                "1e-10",
                "NaN",
                "Infinity",
                "1e999999999",
                "1e-999999999",
                "",
                "soon",
                "1 s",
                "0x1p3",
                "1,5"
            })
    void whatIsNoTimeIsRefused(String written) {
        assertThatThrownBy(() -> reader.convert(written))
                .isInstanceOf(TypeConversionException.class)
                .hasMessage(
                        "'"
                                + written
                                + "' is not a time; give more than 0 seconds, as in 60 or 0.5");
    }
}
