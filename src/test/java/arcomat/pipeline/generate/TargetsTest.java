package arcomat.pipeline.generate;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import arcomat.pipeline.PathNames;
import arcomat.pipeline.WrongUse;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.nio.file.Files;
import java.nio.file.Path;

/** Folders that somebody calls a target. */
class TargetsTest {
    @TempDir private Path folder;

    @Test
    void aDescriptionThatIsNoPropertiesIsRefused() throws Exception {
        Files.writeString(folder.resolve("target.properties"), "flag = has{Port}\n");
        assertThat(Targets.find(folder.toString(), new PathNames(folder)).name())
                .isEqualTo(folder.toString());
        Files.writeString(folder.resolve("target.properties"), "flag = \\u00zz\n");
        assertThatThrownBy(() -> Targets.find(folder.toString(), new PathNames(folder)))
                .isInstanceOf(WrongUse.class)
                .hasMessageEndingWith(
                        "/target.properties: a backslash and a u without four hexadecimal digits"
                                + " behind them");
    }
}
