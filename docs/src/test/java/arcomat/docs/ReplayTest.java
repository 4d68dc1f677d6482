package arcomat.docs;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;

/** A page cannot say what is not so. */
class ReplayTest {
    @TempDir private Path directory;

    @ParameterizedTest
    @ValueSource(
            strings = {
                "```\nanything\n```",
                "```java\nint i;\n```",
                "```arc\ncomponent A {}\n```",
                "```arc A.arc\ncomponent A {}\n```",
                "```arc a/A.arc\ncomponent A {}\n```\n\n```console\n$ arcomat check b\n...\n```",
                "```console\nno command\n```",
                "```console\n$ rm -r /\n```",
                "```console\n$ gradle build\n...\n```",
                "```java of build.gradle\nint i;\n```",
                "```yaml\nrun: arcomat check --formt sarif models\n```",
                "```yaml\nrun: arcomat check --format sraif models\n```",
                "```yaml\nrun: arcomat chekc models\n```",
                "```yaml\n- a: [b\n```",
                "```shell\n./gradlew tset\n```",
                "```groovy\nplugins {}\n```",
                "```synopsis\narcomat check PATH --formt FORMAT\n```",
                "```files\nsrc/mian/java\n```",
                "- a list\n  ```\n  anything\n  ```",
            })
    void refusesWhatNobodyCouldCheckOrDo(String page) {
        assertThatThrownBy(() -> replay(page)).isNotInstanceOf(NullPointerException.class);
    }

    @Test
    void showsWhatIsPrintedInstead() throws IOException {
        Map<Fence, Session> news =
                replay(
                        """
                        ```arc a/A.arc
                        package a;

                        component A { }
                        ```

                        ```console
                        $ arcomat check a
                        1 error in 1 file
                        $ arcomat format --check a
                        ...
                        ```
                        """);
        assertThat(news.values().iterator().next().lines())
                .containsExactly(
                        "$ arcomat check a",
                        "no findings in 1 file",
                        "$ arcomat format --check a",
                        "...");
    }

    private Map<Fence, Session> replay(String page) throws IOException {
        Path file = directory.resolve("page.md");
        Files.writeString(file, page);
        return new Replay(directory, BuildTasks.read(), false).run(Fence.of(file));
    }
}
