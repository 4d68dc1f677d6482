package arcomat.pipeline.live;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import arcomat.pipeline.PathNames;
import arcomat.pipeline.WrongUse;
import arcomat.source.SourceFile;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/** A page carries the worlds that are named, and what their robots run. */
class CarriedWorldsTest {
    private static final String WORLD =
            """
            floor 2000 1000
            kind rover
              program component yard.Rover in ../models
              body 80 900
            robot one rover at 300 500
            """;

    @TempDir Path folder;

    @BeforeEach
    void writeModelsAndWorlds() throws IOException {
        for (String name : List.of("models/yard", "worlds", "empty")) {
            Files.createDirectories(folder.resolve(name));
        }
        Files.writeString(
                folder.resolve("models/yard/Rover.arc"), "package yard; component Rover {}");
        Files.writeString(folder.resolve("worlds/yard.world"), WORLD);
    }

    private CarriedWorlds find(String... paths) throws WrongUse {
        return CarriedWorlds.find(List.of(paths), new PathNames(folder));
    }

    @Test
    void aWorldBringsTheModelsOfItsRobots() throws WrongUse {
        CarriedWorlds found = find("worlds/yard.world");
        assertThat(found.worlds())
                .extracting(SourceFile::path)
                .containsExactly("worlds/yard.world");
        assertThat(found.models()).containsExactly("models");
    }

    @Test
    void worldsBelowAFolderAreCarried() throws WrongUse {
        CarriedWorlds found = find(".");
        assertThat(found.worlds()).hasSize(1);
        assertThat(found.models()).as("the folder has them already").containsExactly(".");
    }

    @Test
    void whereThereIsNoWorldNothingIsCarried() throws WrongUse {
        CarriedWorlds found = find("models/yard/Rover.arc", "empty");
        assertThat(found.worlds()).isEmpty();
        assertThat(found.models()).containsExactly("models/yard/Rover.arc", "empty");
    }

    @Test
    void aWorldThatIsNotThereIsTold() {
        assertThatThrownBy(() -> find("worlds/meadow.world"))
                .isInstanceOf(WrongUse.class)
                .hasMessageContaining("'worlds/meadow.world' does not exist");
    }
}
