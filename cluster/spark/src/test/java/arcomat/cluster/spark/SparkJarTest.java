package arcomat.cluster.spark;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

import java.io.File;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.jar.JarFile;

/** The jar for {@code spark-submit}, without Spark. */
@Tag("slow")
@Timeout(600)
class SparkJarTest {
    private static final String JAR = System.getProperty("spark.jar");
    private static final String JAVA =
            Path.of(System.getProperty("java.home"), "bin", "java").toString();

    @TempDir private Path temporary;

    @Test
    void saysThatThereIsNoSpark() throws Exception {
        try (Processes processes = new Processes(temporary, Map.of())) {
            assertThat(processes.start("log", List.of(JAVA, "-jar", JAR)).waitFor()).isEqualTo(2);
            assertThat(processes.output("log")).isEmpty();
            assertThat(processes.output("log.err"))
                    .isEqualToIgnoringNewLines(
                            "arcomat: there is no Spark here: give this jar to spark-submit, with"
                                    + " --class arcomat.cluster.spark.SparkCampaign");
        }
    }

    /** Two copies of a class would hide that Spark's is the one that is loaded. */
    @Test
    void leavesToSparkWhatSparkHas() throws Exception {
        try (JarFile jar = new JarFile(JAR)) {
            assertThat(jar.stream().map(Object::toString))
                    .contains("META-INF/NOTICE", "META-INF/LICENSE", "arcomat/cli/Embedded.class")
                    .noneMatch(
                            name ->
                                    name.matches(
                                            "org/(antlr|slf4j|apache)/.*|com/(google|fasterxml)/.*"
                                                    + "|scala/.*|META-INF/.*\\.(SF|RSA|DSA)"));
        }
    }

    /** Nothing that it leaves out beside Spark's is asked for by any kind of question. */
    @Test
    void hasAllThatACampaignNeedsBesideSpark() throws Exception {
        Questions.write(temporary);
        String classes = JAR + File.pathSeparator + System.getProperty("of.spark");
        List<String> command = List.of(JAVA, "-cp", classes, "arcomat.cli.Main", "campaign");
        try (Processes processes = new Processes(temporary, Map.of())) {
            List<String> all = Questions.asked(command, "--out", "out", "--report", "page");
            int status = processes.start("log", all).waitFor();
            assertThat(status).as(processes.output("log.err")).isZero();
            assertThat(processes.output("log")).contains("decided before", "wrote page");
        }
    }
}
