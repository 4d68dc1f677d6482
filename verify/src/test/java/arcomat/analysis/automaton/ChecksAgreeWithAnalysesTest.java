package arcomat.analysis.automaton;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.search.Budget;
import arcomat.check.Checks;
import arcomat.check.DataFile;
import arcomat.check.law.Profile;
import arcomat.laws.draw.ComponentText;
import arcomat.laws.draw.Draw;
import arcomat.laws.draw.Features;
import arcomat.lower.Lowering;
import arcomat.model.Component;
import arcomat.model.Value;
import arcomat.models.ModelFiles;
import arcomat.models.ReadModels;
import arcomat.semantics.Promise;
import arcomat.semantics.expression.Arguments;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;
import arcomat.symbols.Workspace;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;

/** Whatever checks say without looking at runs, analyses say, too, of the same places. */
class ChecksAgreeWithAnalysesTest {
    private static final Set<String> SHARED = Set.of("ARC1001", "ARC1003");
    private static final int MODELS = 400;
    private static final int WORTH_IT = 60;

    @Tag("some-slow")
    @ParameterizedTest
    @ValueSource(strings = {"verify/src/test/resources/analyze", "src/test/resources/check"})
    void onData(String folder) throws IOException {
        try (Stream<Path> files = Files.list(Path.of(folder))) {
            for (Path file : files.filter(each -> each.toString().endsWith(".arc")).toList()) {
                agree(DataFile.read(file).files());
            }
        }
    }

    @Test
    void onTheModelsOfThisProject() {
        agree(ModelFiles.of(Path.of("models/coffee")));
    }

    @Tag("slow")
    @Test
    void onRandomModels() {
        int told = 0;
        for (int seed = 0; seed < MODELS; seed++) {
            Draw draw = new Draw(seed, EnumSet.allOf(Features.class));
            boolean events = draw.chance(15);
            SourceFile main =
                    ComponentText.atomic(
                            draw, "a", "Main", ComponentText.plugs(draw, events), events, 1);
            told += agree(List.of(ComponentText.types(), main));
        }
        assertThat(told).isGreaterThan(WORTH_IT);
    }

    /** How many findings there are. */
    private static int agree(List<SourceFile> files) {
        Workspace workspace = ReadModels.workspace(files);
        List<Diagnostic> all = Checks.run(workspace, Profile.REQUIREMENTS);
        if (all.stream().anyMatch(Diagnostic::isError)) {
            return 0;
        }
        Set<String> checked = new TreeSet<>(places(all));
        checked.addAll(places(Checks.run(workspace, Profile.EXECUTABLE)));
        if (!checked.isEmpty()) {
            assertThat(analyzed(workspace)).as(files::toString).containsAll(checked);
        }
        return checked.size();
    }

    private static Set<String> analyzed(Workspace workspace) {
        List<Diagnostic> found = new ArrayList<>();
        Budget budget = new Budget(() -> false, 20_000).patient(2_000_000);
        for (Component component : Lowering.lower(workspace).components()) {
            if (component.hasDefaults() && !component.automata().isEmpty()) {
                List<Value> arguments = Arguments.complete(component, List.of());
                Promise promise = new Promise(component, arguments, component.automata());
                Analyses.examine(promise, List.of(), budget)
                        .forEach(each -> each.findings().forEach(f -> found.add(f.diagnostic())));
            }
        }
        return places(found);
    }

    private static Set<String> places(List<Diagnostic> findings) {
        Set<String> places = new TreeSet<>();
        for (Diagnostic each : findings) {
            if (SHARED.contains(each.code())) {
                places.add(each.code() + " " + each.span() + " " + related(each));
            }
        }
        return places;
    }

    private static List<String> related(Diagnostic finding) {
        return finding.related().stream().map(each -> each.span() + " " + each.note()).toList();
    }
}
