package arcomat.fuzz;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.check.Checks;
import arcomat.check.law.Profile;
import arcomat.lower.Lowering;
import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.model.Model;
import arcomat.model.Parameter;
import arcomat.model.Value;
import arcomat.pipeline.compile.Agreement;
import arcomat.report.finding.FindingsText;
import arcomat.report.text.Style;
import arcomat.rt.ModelError;
import arcomat.semantics.network.Network;
import arcomat.simulate.test.StreamTests;
import arcomat.source.Diagnostic;
import arcomat.source.Span;
import arcomat.symbols.Workspace;
import arcomat.syntax.Formatter;
import arcomat.syntax.Parser;
import arcomat.syntax.TreeText;
import arcomat.translate.HouseLanguages;
import arcomat.tree.Unit;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;

/**
 * What holds for models however damaged they are: every stage ends with a result or with findings
 * that lie in their file; and what one stage lets pass, the next one can work with.
 */
final class Harmless {
    /** How far a set of models came. */
    enum Stage {
        TEXT,
        TREE,
        MODEL,
        CODE
    }

    private static final int RUN_COMPONENTS = 3;
    private static final int WORDS = 3;
    private static final int LETTERS = 20;

    private final ModelSet original;
    private final TreeMap<String, Component> originalComponents = new TreeMap<>();
    private final Set<String> originalErrors;

    /**
     * @param original a set without errors in the profile of requirements
     */
    Harmless(ModelSet original) {
        this.original = original;
        Workspace workspace = workspace(original);
        assertThat(errors(Checks.run(workspace, Profile.REQUIREMENTS))).isEmpty();
        this.originalErrors = errors(Checks.run(workspace, Profile.EXECUTABLE));
        Lowering.lower(workspace)
                .components()
                .forEach(c -> originalComponents.put(c.qualifiedName(), c));
    }

    Stage check(ModelSet damaged) {
        damaged.files().values().stream()
                .filter(parsing -> !original.files().containsValue(parsing))
                .forEach(Harmless::checkText);
        Workspace workspace = workspace(damaged);
        List<Diagnostic> findings = Checks.run(workspace, Profile.REQUIREMENTS);
        checkPlaces(findings);
        FindingsText.render(findings, Style.PLAIN);
        boolean broken =
                damaged.files().values().stream().anyMatch(p -> p.parsed().unit().isEmpty());
        if (broken || !errors(findings).isEmpty()) {
            checkPlaces(Checks.run(workspace, Profile.EXECUTABLE));
            return broken ? Stage.TEXT : Stage.TREE;
        }
        return checkModel(Lowering.lower(workspace), workspace);
    }

    private static void checkText(ModelSet.Parsing parsing) {
        var file = parsing.file();
        var parsed = parsing.parsed();
        checkPlaces(parsed.findings());
        FindingsText.render(parsed.findings(), Style.PLAIN);
        assertThat(parsed.unit().isPresent()).isEqualTo(parsed.findings().isEmpty());
        var formatted = Formatter.format(file).text();
        assertThat(formatted.isPresent()).isEqualTo(parsed.unit().isPresent());
        if (formatted.isPresent()) {
            var canonical = new arcomat.source.SourceFile(file.path(), formatted.get());
            assertThat(Formatter.format(canonical).text()).isEqualTo(formatted);
            assertThat(TreeText.of(Parser.parse(canonical).unit().orElseThrow()))
                    .isEqualTo(TreeText.of(parsed.unit().get()));
        }
    }

    private Stage checkModel(Model model, Workspace workspace) {
        model.tests().forEach(StreamTests::run);
        List<Diagnostic> findings = Checks.run(workspace, Profile.EXECUTABLE);
        checkPlaces(findings);
        if (!originalErrors.containsAll(errors(findings))) {
            return Stage.MODEL;
        }
        List<Component> changed =
                model.components().stream()
                        .filter(c -> !c.equals(originalComponents.get(c.qualifiedName())))
                        .filter(Harmless::isExecutable)
                        .filter(Harmless::canBegin)
                        .limit(RUN_COMPONENTS)
                        .toList();
        changed.forEach(c -> new Agreement(c, arguments(c)).holds(WORDS, LETTERS));
        return changed.isEmpty() ? Stage.MODEL : Stage.CODE;
    }

    private static void checkPlaces(List<Diagnostic> findings) {
        for (Diagnostic finding : findings) {
            checkPlace(finding.span());
            finding.related().forEach(related -> checkPlace(related.span()));
        }
    }

    private static void checkPlace(Span span) {
        assertThat(span.start()).isBetween(0, span.end());
        assertThat(span.end()).isLessThanOrEqualTo(span.file().text().length());
    }

    private static Workspace workspace(ModelSet set) {
        List<Unit> units = new ArrayList<>();
        Set<String> broken = new HashSet<>();
        set.files()
                .forEach(
                        (path, parsing) ->
                                parsing.parsed()
                                        .unit()
                                        .ifPresentOrElse(units::add, () -> broken.add(path)));
        return Workspace.of(units, broken, HouseLanguages.reader());
    }

    private static Set<String> errors(List<Diagnostic> findings) {
        Set<String> errors = new TreeSet<>();
        findings.stream()
                .filter(Diagnostic::isError)
                .forEach(f -> errors.add(f.span().file().path() + " " + f.code()));
        return errors;
    }

    /** What the executable profile asks for, as far as it is a matter of the component. */
    private static boolean isExecutable(Component component) {
        if (component.platform()) {
            return false;
        }
        if (component.body() instanceof Component.Composite composite) {
            return !composite.parts().isEmpty()
                    && composite.parts().stream()
                            .map(Component.Part::component)
                            .allMatch(part -> part.platform() || isExecutable(part));
        }
        var automata = ((Component.Atomic) component.body()).automata();
        return automata.size() == 1 && automata.get(0).initials().size() == 1;
    }

    /** The arguments made up here may lead to one that a part's range forbids. */
    private static boolean canBegin(Component component) {
        try {
            Network.of(component, arguments(component));
            return true;
        } catch (ModelError refused) {
            return false;
        }
    }

    private static List<Value> arguments(Component component) {
        List<Value> arguments = new ArrayList<>();
        for (Parameter parameter : component.parameters()) {
            arguments.add(
                    parameter
                            .initial()
                            .filter(Expression.Constant.class::isInstance)
                            .map(initial -> ((Expression.Constant) initial).value())
                            .orElseGet(() -> parameter.type().first()));
        }
        return arguments;
    }
}
