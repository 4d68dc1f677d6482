package arcomat.check.walk;

import arcomat.check.Checks;
import arcomat.check.law.Check;
import arcomat.check.law.Check.Context;
import arcomat.check.law.Check.Findings;
import arcomat.check.law.Profile;
import arcomat.check.law.Suppressions;
import arcomat.check.walk.Listeners.Listener;
import arcomat.symbols.Workspace;
import arcomat.symbols.bodies.AutomatonSymbol;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.StreamTestSymbol;
import arcomat.symbols.bodies.TestSuiteSymbol;
import arcomat.symbols.names.DiagramSymbol;
import arcomat.tree.QualifiedName;
import arcomat.tree.TestSuite;
import arcomat.tree.Unit;

import java.util.ArrayList;
import java.util.List;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.function.Predicate;

/**
 * The one walk over a workspace: files and what they define. Its steps do not depend on one
 * another, so several walks may share them; see {@link Checks#review}.
 */
public final class Walk {
    private final Workspace workspace;
    private final Profile profile;
    private final Listeners listeners;
    private final Suppressions suppressions = new Suppressions();
    private final ExpressionWalk expressions;
    private final BehaviourWalk behaviours;
    private final ComponentWalk components;
    private final DiagramWalk diagrams;

    public Walk(Workspace workspace, Profile profile, Listeners listeners) {
        this.workspace = workspace;
        this.profile = profile;
        this.listeners = listeners;
        StereotypeWalk stereotypes = new StereotypeWalk(listeners, suppressions);
        this.expressions = new ExpressionWalk(listeners);
        this.behaviours = new BehaviourWalk(listeners, stereotypes, expressions);
        this.diagrams = new DiagramWalk(listeners, stereotypes, expressions);
        this.components = new ComponentWalk(listeners, stereotypes, expressions, behaviours);
    }

    /** The laws about all files together, then one step for each definition in wanted files. */
    public static List<Consumer<Walk>> steps(Workspace workspace, Predicate<Unit> wanted) {
        List<Consumer<Walk>> steps = new ArrayList<>();
        steps.add(walk -> walk.workspace(workspace));
        for (ComponentSymbol each : workspace.topLevelComponents()) {
            add(wanted, each.unit(), (walk, at) -> walk.component(each, at), steps);
        }
        for (AutomatonSymbol each : workspace.bareAutomata()) {
            add(wanted, each.unit(), (walk, at) -> walk.behaviours.automaton(each, at), steps);
        }
        for (DiagramSymbol each : workspace.diagrams()) {
            add(wanted, each.unit(), (walk, at) -> walk.diagrams.classDiagram(each, at), steps);
        }
        for (TestSuiteSymbol each : workspace.testSuites()) {
            add(wanted, each.unit(), (walk, at) -> walk.testSuite(each, at), steps);
        }
        return steps;
    }

    private static void add(
            Predicate<Unit> wanted,
            Unit unit,
            BiConsumer<Walk, Context> definition,
            List<Consumer<Walk>> steps) {
        if (wanted.test(unit)) {
            steps.add(walk -> walk.unit(unit, definition));
        }
    }

    /** Takes over what another walk has seen. */
    public Walk join(Walk other) {
        listeners.addAll(other.listeners);
        suppressions.addAll(other.suppressions);
        return this;
    }

    public List<Findings> findings() {
        return listeners.findings();
    }

    public Suppressions suppressions() {
        return suppressions;
    }

    private void workspace(Workspace workspace) {
        for (Listener<Check.OnWorkspace> each : listeners.onWorkspace) {
            each.check().check(workspace, each.findings());
        }
    }

    private void unit(Unit unit, BiConsumer<Walk, Context> definition) {
        Context context = Context.of(workspace, profile, unit);
        for (Listener<Check.OnUnit> each : listeners.onUnit) {
            each.check().check(unit, context, each.findings());
        }
        definition.accept(this, context);
        List<QualifiedName> names = expressions.takeNames();
        if (!unit.imports().isEmpty()) {
            for (Listener<Check.OnNames> each : listeners.onNames) {
                each.check().check(names, context, each.findings());
            }
        }
    }

    /** What has features is what its configurations are, each by itself. */
    private void component(ComponentSymbol component, Context context) {
        if (component.declaration().isOpen()) {
            ConfigurationFindings found = new ConfigurationFindings(listeners.findings());
            for (ComponentSymbol each : workspace.configurations(component)) {
                components.component(each, context);
                found.in(each);
            }
            found.tell();
        } else {
            components.component(component, context);
        }
    }

    private void testSuite(TestSuiteSymbol suite, Context context) {
        expressions.name(suite.node().component());
        for (Listener<Check.OnTestSuite> each : listeners.onTestSuite) {
            each.check().check(suite, context, each.findings());
        }
        expressions.arguments(suite.arguments(), context);
        for (TestSuite.Member member : suite.node().members()) {
            if (member instanceof TestSuite.Field field && !isForJava(field)) {
                expressions.type(field.type(), context);
            }
        }
        suite.fields().forEach(field -> expressions.variable(field, context));
        for (StreamTestSymbol test : suite.tests()) {
            streamTest(test, context);
        }
    }

    /**
     * No message is an array, so that no test can name the field: that it has no effect is told.
     */
    private static boolean isForJava(TestSuite.Field field) {
        return field.type().dimensions() > 0;
    }

    private void streamTest(StreamTestSymbol test, Context context) {
        for (Listener<Check.OnStreamTest> each : listeners.onStreamTest) {
            each.check().check(test, context, each.findings());
        }
        for (StreamTestSymbol.StreamSymbol stream : test.streams()) {
            expressions.values(stream.messages(), stream.type(), context);
        }
    }
}
