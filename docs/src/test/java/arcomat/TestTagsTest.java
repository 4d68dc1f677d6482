package arcomat;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/** A tag takes a test out of {@code test}: another task has to run it, here and in CI. */
class TestTagsTest {
    private static final Pattern TAG = Pattern.compile("Tag\\(\"([a-z-]+)\"\\)");
    private static final Pattern IN_BROWSER = Pattern.compile("class \\w+ extends BrowserTest\\b");
    private static final Pattern TAG_OF_PROPERTY =
            Pattern.compile("\n    @Tag\\(\"[a-z-]+\"\\)\\s+@Property");
    private static final Pattern PROJECT = Pattern.compile("'([a-z-]+)': '([a-z/]+)'");

    /** A project of the build, with its tests. */
    private record Project(String name, Path folder) {
        Set<String> tags() throws IOException {
            Set<String> tags = new TreeSet<>();
            for (Path file : sources()) {
                tags.addAll(tags(Files.readString(file)));
            }
            return tags;
        }

        List<Path> sources() throws IOException {
            try (Stream<Path> files = Files.walk(folder.resolve("src/test/java"))) {
                return files.filter(each -> each.toString().endsWith(".java")).toList();
            }
        }

        /** Those that a class inherits, too. */
        private static Set<String> tags(String text) {
            Set<String> tags = new TreeSet<>();
            TAG.matcher(text)
                    .results()
                    .forEach(tag -> tags.add(tag.group(1).replace("some-slow", "slow")));
            if (IN_BROWSER.matcher(text).find()) {
                tags.add("browser");
            }
            return tags;
        }

        boolean hasTests() {
            return Files.isDirectory(folder.resolve("src/test/java"));
        }
    }

    private static List<Project> projects() throws IOException {
        String settings = Files.readString(Path.of("settings.gradle"));
        Stream<Project> named =
                PROJECT.matcher(settings)
                        .results()
                        .map(each -> new Project(":" + each.group(1), Path.of(each.group(2))));
        return Stream.concat(Stream.of(new Project("", Path.of(""))), named)
                .filter(Project::hasTests)
                .toList();
    }

    /** A property that has the other kind of tag runs in every task. */
    @Test
    void propertiesHaveTagsOfTheirOwnLibrary() throws IOException {
        for (Project project : projects()) {
            for (Path file : project.sources()) {
                String text = Files.readString(file);
                if (text.contains("import org.junit.jupiter.api.Tag;")) {
                    assertThat(text).as("%s", file).doesNotContainPattern(TAG_OF_PROPERTY);
                }
            }
        }
    }

    @Test
    void eachHasItsTask() throws IOException {
        String ci = Files.readString(Path.of(".ci/run"));
        for (Project project : projects()) {
            String build = Files.readString(project.folder().resolve("build.gradle"));
            for (String tag : project.tags()) {
                String task = project.name() + ":" + tag + "Test";
                assertThat(build).as(task).contains("testGroup('" + tag + "')");
                if (!tag.equals("slow")) {
                    assertThat(ci).as("%s in .ci/run", task).contains("\n" + task + " ");
                }
            }
        }
    }
}
