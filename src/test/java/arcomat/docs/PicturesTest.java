package arcomat.docs;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.model.Automaton.Completion;
import arcomat.pipeline.Pipeline;
import arcomat.pipeline.analysis.AnalysisLimits;
import arcomat.pipeline.analysis.RefinesRequest;
import arcomat.pipeline.diagram.DiagramRequest;
import arcomat.pipeline.picture.PictureFormat;
import arcomat.pipeline.step.Progress;

import org.junit.jupiter.api.Test;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/** The pictures in the documents are what the tool draws today; if not: ./gradlew pictures. */
class PicturesTest {
    private static final Path COMMITTED = Path.of("docs/pictures");

    /** As deep as those: links to models are relative. */
    private static final Path DRAWN = Path.of("build/pictures");

    private static final List<String> MODELS = List.of("models/coffee");
    private final Pipeline pipeline = new Pipeline(Path.of(""), Progress.NONE);

    @Test
    void componentsAndAutomata() throws Exception {
        List<String> components =
                List.of("coffee.fetcher.Fetcher", "coffee.fig6.AvoidCrash", "coffee.types.Types");
        String out = DRAWN.resolve("coffee").toString();
        DiagramRequest request =
                new DiagramRequest(components, PictureFormat.svg, out, 1000, Optional.empty());
        List<String> files = pipeline.diagram(request, MODELS).files();
        assertThat(files).hasSize(4);
        for (String file : files) {
            same("coffee/" + file);
        }
    }

    @Test
    void counterexample() throws Exception {
        Optional<Completion> ignore = Optional.of(Completion.IGNORE);
        RefinesRequest request =
                new RefinesRequest(
                        "coffee.fig6.AvoidCrash",
                        "coffee.fig5.AvoidCrash",
                        ignore,
                        ignore,
                        Optional.empty(),
                        Optional.empty(),
                        Optional.empty(),
                        Optional.of(DRAWN.resolve("refines.svg").toString()),
                        new AnalysisLimits(Optional.empty(), Optional.empty()));
        pipeline.refines(request, MODELS);
        same("refines.svg");
    }

    private static void same(String file) throws Exception {
        assertThat(Files.readString(DRAWN.resolve(file)))
                .as("docs/pictures/%s; ./gradlew pictures draws it anew", file)
                .isEqualTo(Files.readString(COMMITTED.resolve(file)));
    }
}
