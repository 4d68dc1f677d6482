package arcomat.pipeline.explored;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;

/** Each promise has a name that every file system takes, and that no other one has. */
class PromiseNameTest {
    private static final String LONG = "p.Row(\"" + "ä/..\\:*?".repeat(200) + "\")";

    @Test
    void isItsOwn() {
        List<PromiseName> all =
                List.of(
                        new PromiseName("p.Row refines p.Any", 1),
                        new PromiseName("p.Row refines p.Any", 2),
                        new PromiseName("p.row refines p.any", 1),
                        new PromiseName("p.Row keeps invariant any", 1),
                        new PromiseName(LONG + " refines A", 1),
                        new PromiseName(LONG + " refines B", 1));
        Set<String> names = new HashSet<>();
        for (PromiseName each : all) {
            String name = each.asFile();
            assertThat(name).matches("[a-z0-9-]{1,80}").doesNotStartWith("-");
            assertThat(names.add(name.toLowerCase(Locale.ROOT))).as(name).isTrue();
        }
    }

    @Test
    void tellsWhatItIsAbout() {
        assertThat(new PromiseName("p.Row refines p.Any", 1).asFile())
                .matches("p-row-refines-p-any-[0-9a-f]{24}")
                .isEqualTo(new PromiseName("p.Row refines p.Any", 1).asFile());
    }
}
