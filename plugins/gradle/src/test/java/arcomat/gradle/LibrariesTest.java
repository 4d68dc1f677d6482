package arcomat.gradle;

import static arcomat.gradle.ConsumerProject.outcomes;

import static org.assertj.core.api.Assertions.assertThat;

import org.gradle.testkit.runner.BuildResult;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.jar.JarFile;
import java.util.zip.ZipEntry;

/**
 * Models as artifacts: those of one project refer to those of another one, whose jar has the code.
 */
@Tag("build")
class LibrariesTest {
    private static final String ROVER = "src/main/arc/shop/Rover.arc";
    private static final String BUMPER = "parts/src/main/arc/shop/Bumper.arc";
    private static final String CODE = "robot/build/generated/sources/arcomat/generateArcJvm/shop";

    @TempDir private Path folder;
    private ConsumerProject shop;

    @BeforeEach
    void setUp() {
        shop =
                ConsumerProject.shopOfTwo(
                        folder, PUBLISHING, "dependencies { arcomatModels project(':parts') }");
        shop.write("parts/src/test/arc/shop/BumperTest.mt", shop.read(TEST));
        shop.write("robot/src/main/java/shop/Lap.java", shop.read("src/main/java/shop/Lap.java"));
    }

    private static final String TEST = "src/test/arc/shop/BumperTest.mt";

    private static final String PUBLISHING =
            """
            apply plugin: 'maven-publish'
            group = 'shop'
            version = '1'
            publishing {
                publications { java(MavenPublication) { from components.java } }
                repositories { maven { url = rootProject.file('repository') } }
            }
            """;

    @Test
    void codeOfOthersComesByTheirJar() throws IOException {
        shop.edit(BUMPER, "Boolean wall", "Boolean Wall");
        shop.edit(BUMPER, "{wall == true}", "{Wall == true}");
        shop.edit(BUMPER, "{wall == false}", "{Wall == false}");
        shop.edit("robot/" + ROVER, "bumper.wall", "bumper.Wall");
        shop.edit("parts/src/test/arc/shop/BumperTest.mt", "wall:", "Wall:");

        BuildResult built = shop.build("build");
        assertThat(outcomes(built))
                .contains(
                        ":parts:testArc SUCCESS",
                        ":robot:testArc NO_SOURCE",
                        ":robot:compileJava SUCCESS",
                        ":robot:nxtJar SUCCESS",
                        ":robot:build SUCCESS");
        assertThat(shop.read("parts/build/reports/arcomat/checkArc.txt")).contains("ARC0210");
        assertThat(shop.read("robot/build/reports/arcomat/checkArc.txt"))
                .isEqualTo("no findings in 1 file\n");

        assertThat(shop.path(CODE + "/logic/Bumper.java")).doesNotExist();
        assertThat(entries("robot/build/libs/robot.jar"))
                .contains("shop/Lap.class") // which uses a bumper
                .anyMatch(name -> name.matches("shop/\\w+/Rover.class"))
                .noneMatch(entries("parts/build/libs/parts-1.jar")::contains);
        assertThat(entries("robot/build/nxt/Rover.jar")).contains("shop/logic/Bumper.class");
        assertThat(entries("parts/build/libs/parts-1-models.jar"))
                .containsExactly("shop/Bumper.arc", "shop/Gear.arc", "shop/Shop.cd");
    }

    /** Without folders, and what each jar says of itself. */
    private List<String> entries(String jar) throws IOException {
        try (JarFile file = new JarFile(shop.path(jar).toFile())) {
            return file.stream()
                    .filter(entry -> !entry.isDirectory())
                    .map(ZipEntry::getName)
                    .filter(name -> !name.startsWith("META-INF/"))
                    .sorted()
                    .toList();
        }
    }

    @Test
    void aChangeOfAModelIsSeenByThoseThatReferToIt() {
        shop.build(":robot:checkArc");
        assertThat(outcomes(shop.build(":robot:checkArc"))).contains(":robot:checkArc UP_TO_DATE");
        shop.edit(BUMPER, "out Command wheels", "out Boolean wheels");
        shop.edit(BUMPER, "wheels = go};", "wheels = true};");
        shop.edit(BUMPER, "{wheels = halt}", "{wheels = false}");

        BuildResult failed = shop.fail(":robot:checkArc");
        assertThat(failed.getOutput())
                .contains("robot/" + ROVER + ":16:30: error ARC0106")
                .contains("1 error in 1 file");
    }

    /** A jar from a repository, with the models that its own models refer to. */
    @Test
    void whatIsPublishedIsReferredToByName() {
        shop.build(":parts:publish");
        shop.edit("settings.gradle", "include 'parts', 'robot'", "include 'robot'");
        shop.edit(
                "robot/build.gradle",
                "dependencies { arcomatModels project(':parts') }",
                """
                repositories { maven { url = rootProject.file('repository') } }
                dependencies { arcomatModels 'shop:parts:1' }
                """);
        BuildResult built = shop.build(":robot:build");
        assertThat(outcomes(built))
                .contains(":robot:unpackArcModels SUCCESS", ":robot:compileJava SUCCESS");
        assertThat(shop.path("robot/build/arcomat/libraries/parts-1-models/shop/Gear.arc"))
                .exists();

        // A build tool that knows nothing of variants: a jar with a classifier.
        shop.delete("repository/shop/parts/1/parts-1.module");
        shop.edit("repository/shop/parts/1/parts-1.pom", "published-with-gradle-metadata", "");
        shop.edit(
                "robot/build.gradle",
                "arcomatModels 'shop:parts:1'",
                "arcomatModels 'shop:parts:1:models'; implementation 'shop:parts:1'");
        assertThat(outcomes(shop.build(":robot:build", "--refresh-dependencies")))
                .contains(":robot:unpackArcModels UP_TO_DATE", ":robot:compileJava SUCCESS");
    }
}
