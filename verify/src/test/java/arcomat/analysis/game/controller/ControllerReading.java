package arcomat.analysis.game.controller;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.refinement.Refinement;
import arcomat.analysis.refinement.Verdict;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.search.Budget;
import arcomat.check.Checks;
import arcomat.check.law.Profile;
import arcomat.generate.ControllerText;
import arcomat.generate.GeneratedFile;
import arcomat.generate.Generation;
import arcomat.generate.Generator;
import arcomat.generate.Request;
import arcomat.generate.Target;
import arcomat.generate.plan.Choosing;
import arcomat.lower.Lowering;
import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.models.ReadModels;
import arcomat.semantics.Promise;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;
import arcomat.symbols.Workspace;
import arcomat.syntax.Formatter;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;

/**
 * A controller as text: the tool reads it, finds nothing wrong, generates code from it, and it
 * means the same.
 */
public final class ControllerReading {
    private static final Budget BUDGET = new Budget(() -> false, 100_000);

    private ControllerReading() {}

    public static SourceFile text(Component controller, Component required) {
        GeneratedFile written =
                ControllerText.of(
                        controller, List.of("Keeps what " + required.name() + " requires."));
        SourceFile file = new SourceFile(written.path(), written.text());
        return new SourceFile(written.path(), Formatter.format(file).text().orElseThrow());
    }

    /** With types and the required component written down as far as the text needs them. */
    public static void check(Component required, Component controller) {
        SourceFile file = text(controller, required);
        String refines = " refines " + required.qualifiedName();
        assertThat(file.text()).contains(refines);
        SourceFile alone = new SourceFile(file.path(), file.text().replace(refines, ""));
        check(List.of(types(required)), alone, controller);
    }

    private static SourceFile types(Component component) {
        Set<String> enums = new TreeSet<>();
        for (Port port : component.ports()) {
            if (port.type() instanceof Type.EnumType type) {
                enums.add(
                        "enum %s { %s; }\n"
                                .formatted(type.simpleName(), String.join(", ", type.constants())));
            }
        }
        return new SourceFile(
                "coffee/Types.cd",
                "package coffee;\nclassdiagram Types {\n" + String.join("", enums) + "}\n");
    }

    public static void check(List<SourceFile> models, SourceFile file, Component controller) {
        Component read = read(models, file, controller.qualifiedName());
        keeps(read, controller);
        keeps(controller, read);
        Generation generation =
                Generator.generate(
                        Request.library(read, Choosing.FIRST), Target.shipped("jvm").orElseThrow());
        assertThat(generation.findings()).isEmpty();
        assertThat(generation.files()).isNotEmpty();
    }

    private static Component read(List<SourceFile> models, SourceFile file, String name) {
        List<SourceFile> sources = new ArrayList<>(models);
        sources.add(file);
        Workspace workspace = ReadModels.workspace(sources);
        List<Diagnostic> findings =
                Checks.run(workspace, Profile.EXECUTABLE).stream()
                        .filter(finding -> finding.span().file().path().equals(file.path()))
                        .toList();
        assertThat(findings).as(file.text()).isEmpty();
        return Lowering.lower(workspace).component(name).orElseThrow();
    }

    private static void keeps(Component one, Component other) {
        Verdict verdict =
                Refinement.check(Promise.of(one, List.of()), Promise.of(other, List.of()), BUDGET);
        assertThat(verdict.answer()).as("%s %s", verdict.reason(), one).isEqualTo(Answer.HOLDS);
    }
}
