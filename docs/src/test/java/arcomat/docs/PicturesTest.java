package arcomat.docs;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.model.Automaton.Completion;
import arcomat.pipeline.Progress;
import arcomat.pipeline.Session;
import arcomat.pipeline.analysis.AnalysisLimits;
import arcomat.pipeline.analysis.ComparedSides;
import arcomat.pipeline.analysis.ProveRefinement;
import arcomat.pipeline.analysis.Prover;
import arcomat.pipeline.diagram.DrawDiagrams;
import arcomat.pipeline.diagram.MarkedFindings;
import arcomat.pipeline.picture.PictureFormat;
import arcomat.pipeline.world.PrepareWorld;
import arcomat.pipeline.world.WriteAnimation;
import arcomat.world.Recording;

import org.junit.jupiter.api.Tag;
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
    private final Session session = Session.in(Path.of(""), Progress.NONE);

    @Tag("slow")
    @Test
    void componentsAndAutomata() throws Exception {
        List<String> components =
                List.of("coffee.fetcher.Fetcher", "coffee.fig6.AvoidCrash", "coffee.types.Types");
        String out = DRAWN.resolve("coffee").toString();
        DrawDiagrams task =
                new DrawDiagrams(
                        components, PictureFormat.svg, out, 1000, MarkedFindings.NONE, MODELS);
        List<String> files = session.run(task).value().orElseThrow();
        assertThat(files).hasSize(4).contains("index.html");
        for (String file : files) {
            if (!file.equals("index.html")) { // it shows the others, and no document shows it
                same("coffee/" + file);
            }
        }
    }

    @Tag("slow")
    @Test
    void counterexample() throws Exception {
        Optional<Completion> ignore = Optional.of(Completion.IGNORE);
        session.run(
                new ProveRefinement(
                        new ComparedSides(
                                "coffee.fig6.AvoidCrash", "coffee.fig5.AvoidCrash", ignore, ignore),
                        new Prover.Engine(),
                        Optional.empty(),
                        Optional.of(DRAWN.resolve("refines.svg").toString()),
                        MODELS,
                        new AnalysisLimits(Optional.empty(), Optional.empty())));
        same("refines.svg");
    }

    @Tag("slow")
    @Test
    void theMeeting() throws Exception {
        String world = MODELS.get(0) + "/world/meeting.world";
        Recording run = session.run(new PrepareWorld(world, false)).run(1);
        String file = DRAWN.resolve("meeting.svg").toString();
        Files.createDirectories(DRAWN);
        session.run(new WriteAnimation(run, world + ", seed 1", file));
        same("meeting.svg");
    }

    private static void same(String file) throws Exception {
        assertThat(Files.readString(DRAWN.resolve(file)))
                .as("docs/pictures/%s; ./gradlew pictures draws it anew", file)
                .isEqualTo(Files.readString(COMMITTED.resolve(file)));
    }
}
