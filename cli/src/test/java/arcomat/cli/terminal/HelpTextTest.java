package arcomat.cli.terminal;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

/** Help in lines that fit. */
class HelpTextTest {
    private static String fit(int width, String... lines) {
        return String.join("\n", HelpText.fit(lines, width)) + "\n";
    }

    @Test
    void paragraphsFlow() {
        assertThat(fit(20, "one two three four", "five six", "", "seven"))
                .isEqualTo("one two three four\nfive six\n\nseven\n");
        assertThat(fit(12, "one two three four", "five six"))
                .isEqualTo("one two\nthree four\nfive six\n");
    }

    @Test
    void examplesStayCommands() {
        assertThat(
                        fit(
                                30,
                                "  arcomat check x",
                                "  arcomat simulate --main p.Robot --seed 7 models"))
                .isEqualTo(
                        """
                          arcomat check x
                          arcomat simulate --main \\
                              p.Robot --seed 7 models
                        """);
    }

    @Test
    void whatAnExampleShowsStandsBelowIt() {
        assertThat(fit(40, "  arcomat check p/Robot.arc      one file and what it refers to"))
                .isEqualTo(
                        """
                          arcomat check p/Robot.arc
                              one file and what it refers to
                        """);
    }

    @Test
    void aWordThatIsTooLongIsNotBroken() {
        assertThat(fit(5, "abcdefghij")).isEqualTo("abcdefghij\n");
    }
}
