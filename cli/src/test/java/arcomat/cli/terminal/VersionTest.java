package arcomat.cli.terminal;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class VersionTest {
    /** The time of a folder does not tell of a file in it that became another one. */
    @Test
    void knowsEveryFileOfAToolThatIsBeingWorkedOn() {
        assertThat(Version.identity())
                .startsWith(Version.number())
                .contains("Version.class ", "library/index.txt ")
                .isEqualTo(Version.identity());
    }
}
