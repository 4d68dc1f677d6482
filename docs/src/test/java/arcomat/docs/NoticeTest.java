package arcomat.docs;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;

/** NOTICE names what the distribution holds of others, in the versions that it holds. */
class NoticeTest {
    private static final Pattern LIBRARY = Pattern.compile("\\s[\\w.-]+:([\\w.-]+):([\\w.-]+)\\s");

    @Test
    void namesEveryLibrary() throws IOException {
        List<String> named =
                LIBRARY.matcher(Files.readString(Path.of("NOTICE")))
                        .results()
                        .map(NoticeTest::jar)
                        .toList();
        List<String> held =
                DistributedJars.all().stream()
                        .map(jar -> jar.getFileName().toString())
                        .filter(jar -> !jar.startsWith("arcomat-"))
                        .toList();
        assertThat(named).containsExactlyInAnyOrderElementsOf(held);
    }

    private static String jar(MatchResult library) {
        return library.group(1) + "-" + library.group(2) + ".jar";
    }
}
