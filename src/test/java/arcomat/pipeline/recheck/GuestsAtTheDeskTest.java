package arcomat.pipeline.recheck;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.guest.host.Guests;
import arcomat.pipeline.PathNames;
import arcomat.pipeline.Progress;
import arcomat.pipeline.Session;
import arcomat.pipeline.guest.WelcomeGuests;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;
import arcomat.symbols.occurrences.Occurrences;
import arcomat.tree.Unit;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.spi.ToolProvider;

/** What somebody edits may be in a language that a guest brings. */
class GuestsAtTheDeskTest {
    private static final String SHOWN =
            """
            package p;

            component Fast {
                timing instant;
                port in Integer speed, out Boolean lit;

                shown lit { speed > 3 }
            }
            """;

    /** Shows whether a condition holds, which is taken over letter by letter. */
    private static final String GUEST =
            """
            package shown;

            import arcomat.guest.*;
            import java.util.List;

            public final class Shown implements Guest, BehaviourLanguage {
                public int api() { return API; }
                public String name() { return "shown"; }
                public List<BehaviourLanguage> languages() { return List.of(this); }
                public String keyword() { return "shown"; }

                public void translate(Written behaviour, Meaning meaning) {
                    String text = behaviour.body().text();
                    int start = text.length() - text.stripLeading().length();
                    var place = behaviour.part(start, text.stripTrailing().length());
                    meaning.write(behaviour.keyword(), "state on; initial on; on [");
                    meaning.write(place, "%s", place.text());
                    meaning.write(behaviour.keyword(), "] / {%s = true};",
                            behaviour.name().orElseThrow().text());
                }
            }
            """;

    @TempDir private Path folder;
    private Guests guests;

    @BeforeEach
    void compileTheGuest() throws Exception {
        Path source = Files.writeString(folder.resolve("Shown.java"), GUEST);
        Path classes = folder.resolve("shown");
        StringWriter said = new StringWriter();
        int status =
                ToolProvider.findFirst("javac")
                        .orElseThrow()
                        .run(
                                new PrintWriter(said),
                                new PrintWriter(said),
                                source.toString(),
                                "-d",
                                classes.toString());
        assertThat(status).as(said.toString()).isZero();
        Path services = Files.createDirectories(classes.resolve("META-INF/services"));
        Files.writeString(services.resolve("arcomat.guest.Guest"), "shown.Shown\n");
        Session session = new Session(new PathNames(folder), Progress.NONE);
        guests = session.run(new WelcomeGuests(List.of("shown")));
    }

    private OpenModels open(String text, Guests who) {
        return OpenModels.in(folder, false, who)
                .with(OpenModels.Edit.of(List.of(new SourceFile("p/Fast.arc", text))))
                .check(() -> {});
    }

    @Test
    void isCheckedAsItsGuestSays() {
        assertThat(open(SHOWN, guests).findings("p/Fast.arc")).isEmpty();
        assertThat(open(SHOWN, Guests.NONE).findings("p/Fast.arc"))
                .extracting(Diagnostic::code)
                .containsExactly("ARC0133");
        Diagnostic typo =
                open(SHOWN.replace("speed >", "sped >"), guests).findings("p/Fast.arc").get(0);
        assertThat(typo.span().text()).isEqualTo("sped");
        assertThat(typo.fix()).as("nobody but the guest may write there").isEmpty();
    }

    /** And nothing that the guest has made up. */
    @Test
    void namesInItAreFound() {
        OpenModels models = open(SHOWN, guests);
        Unit unit = models.parsed("p/Fast.arc").orElseThrow().unit().orElseThrow();
        assertThat(Occurrences.of(models.workspace(), unit))
                .filteredOn(each -> each.span().start() > SHOWN.indexOf("shown"))
                .allMatch(each -> each.span().text().equals(each.referent().name()))
                .extracting(each -> each.span().text())
                .containsExactly("lit", "speed");
    }
}
