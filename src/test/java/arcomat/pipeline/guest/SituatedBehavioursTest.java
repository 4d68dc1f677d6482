package arcomat.pipeline.guest;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.check.LawBook;
import arcomat.check.guest.GuestLaws;
import arcomat.guest.BehaviourLanguage;
import arcomat.guest.Meaning;
import arcomat.guest.SituatedLanguage;
import arcomat.guest.Vicinity;
import arcomat.guest.host.Guests;
import arcomat.pipeline.recheck.OpenModels;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;

import org.junit.jupiter.api.Test;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.atomic.AtomicInteger;

/** When a guest is asked about behaviours where they stand, while somebody edits. */
class SituatedBehavioursTest {
    private static final String LAMP =
            "package p;\n\n"
                    + "import p.Colours.*;\n\n"
                    + "component Lamp {\n"
                    + "    port out Colour lit;\n\n"
                    + "    ask lit { }\n"
                    + "}\n";
    private static final String COLOURS =
            "package p;\n\nclassdiagram Colours { enum Colour { %s; } }\n";

    /** Finds something wrong each time, and counts. */
    private record Counting(AtomicInteger asked, AtomicInteger interrupted)
            implements SituatedLanguage {
        @Override
        public String keyword() {
            return "ask";
        }

        @Override
        public void translate(Written behaviour, Vicinity around, Meaning meaning) {
            asked.incrementAndGet();
            if (behaviour.body().text().contains("wait")) {
                try {
                    Thread.sleep(60_000);
                } catch (InterruptedException e) {
                    interrupted.incrementAndGet();
                }
            }
            meaning.problem(behaviour.keyword(), around.value("lit").orElseThrow().type() + "");
        }
    }

    private final Counting counting = new Counting(new AtomicInteger(), new AtomicInteger());

    private OpenModels models() {
        BehaviourLanguage language = counting;
        Guests.Language known =
                new Guests.Language("asker", "ask", List.of(), new TreeMap<>(), language);
        GuestLaws laws =
                new GuestLaws(
                        "asker",
                        "asker 1",
                        List.of(),
                        List.of(),
                        SituatedBehaviours.in(List.of(known)),
                        code -> Optional.empty());
        Guests guests =
                new Guests(
                        LawBook.of(List.of(laws)),
                        List.of(),
                        List.of(known),
                        List.of(),
                        List.of(),
                        List.of(),
                        List.of(),
                        List.of());
        return OpenModels.in(Path.of("models").toAbsolutePath(), false, guests);
    }

    private static OpenModels written(OpenModels models, String path, String text) {
        return models.with(OpenModels.Edit.of(List.of(new SourceFile(path, text)))).check(() -> {});
    }

    private static String message(OpenModels models) {
        return models.findings("p/Lamp.arc").stream()
                .filter(each -> each.code().startsWith("ARC12"))
                .map(Diagnostic::message)
                .reduce("", String::concat);
    }

    @Test
    void anEditElsewhereAsksNobodyAgainUnlessItChangesWhatIsAround() {
        OpenModels models = written(models(), "p/Lamp.arc", LAMP);
        models = written(models, "p/Colours.cd", COLOURS.formatted("red"));
        int before = counting.asked().get();
        assertThat(message(models)).contains("values=[red]");
        models = written(models, "p/Other.arc", "package p;\n\ncomponent Other {}\n");
        assertThat(counting.asked()).hasValue(before);
        assertThat(message(models)).contains("values=[red]");
        models = written(models, "p/Colours.cd", COLOURS.formatted("red, green"));
        assertThat(counting.asked()).hasValue(before + 1);
        assertThat(message(models)).contains("values=[red, green]");
    }

    @Test
    void oneThatDoesNotComeToItsEndIsInterruptedAndWaitedForOnce() {
        OpenModels models = written(models(), "p/Colours.cd", COLOURS.formatted("red"));
        models = written(models, "p/Lamp.arc", LAMP.replace("{ }", "{ wait }"));
        assertThat(message(models)).contains("guest 'asker' failed", "not done after 10 s");
        long start = System.nanoTime();
        models = written(models, "p/Other.arc", "package p;\n\ncomponent Other {}\n");
        assertThat(message(models)).contains("not done after 10 s");
        assertThat(System.nanoTime() - start).isLessThan(9_000_000_000L);
        assertThat(counting.asked()).hasValue(1);
        assertThat(counting.interrupted()).hasValue(1);
    }
}
