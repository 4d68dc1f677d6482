package arcomat.pipeline.generate;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.brick.jar.RobotJar.Origin;
import arcomat.brick.jar.RobotJar.RobotClass;
import arcomat.pipeline.FourZones;

import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Optional;

class JarWriterTest {
    @Test
    void theJarIsTheSameInEveryTimeZone() throws Exception {
        List<RobotClass> classes =
                List.of(
                        new RobotClass(
                                "Robot.class",
                                new byte[] {1, 2, 3},
                                Origin.GENERATED,
                                Optional.empty()));
        List<byte[]> jars = FourZones.each(() -> JarWriter.write("Robot", classes));
        assertThat(jars).containsOnly(jars.get(0));
    }
}
