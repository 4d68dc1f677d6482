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

            import arcomat.check.law.*;
            import arcomat.guest.*;
            import arcomat.symbols.Workspace;
            import java.util.List;

            public final class Shown implements Guest, BehaviourLanguage {
                public int api() { return API; }
                public String name() { return "shown"; }
                public List<BehaviourLanguage> languages() { return List.of(this); }
                public String keyword() { return "shown"; }
                public List<Law> laws() { return List.of(Law.warning("SH0001", new Alone())); }

                /** Looks at all files: nothing leads from one to the other. */
                static final class Alone implements Check.OnWorkspace {
                    public void check(Workspace workspace, Findings findings) {
                        if (workspace.components().size() > 1) {
                            workspace.components().forEach(
                                    each -> findings.report(each.nameSpan(), "not alone"));
                        }
                    }
                }

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

    /** What cannot be touched by an edit is known of the tool's own laws only. */
    @Test
    void lawsMayLookAtFilesThatNothingLeadsTo() {
        OpenModels alone = open(SHOWN, guests);
        SourceFile other = new SourceFile("q/Other.arc", "package q;\n\ncomponent Other {}\n");
        OpenModels both = alone.with(OpenModels.Edit.of(List.of(other))).check(() -> {});
        assertThat(both.findings("p/Fast.arc"))
                .extracting(Diagnostic::code)
                .containsExactly("SH0001");
        assertThat(both.findings("q/Other.arc"))
                .extracting(Diagnostic::code)
                .containsExactly("SH0001");
    }

    @Test
    void aStateOfTheLastCheckIsNotReliedOn() throws Exception {
        Path models = Files.createDirectories(folder.resolve("m/p"));
        Files.writeString(models.resolve("Fast.arc"), SHOWN);
        Session session = new Session(new PathNames(folder), Progress.NONE).with(guests);
        CheckAgain again = new CheckAgain(List.of("m"), false, "state", "tool");
        assertThat(session.run(again).result().findings()).isEmpty();
        Files.writeString(models.resolve("Other.arc"), "package p;\n\ncomponent Other {}\n");
        assertThat(session.run(again).result().findings()).hasSize(2);
    }
}
