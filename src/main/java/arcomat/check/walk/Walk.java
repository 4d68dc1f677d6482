package arcomat.check.walk;

import arcomat.check.Checks;
import arcomat.check.law.Check;
import arcomat.check.law.Context;
import arcomat.check.law.Findings;
import arcomat.check.law.Profile;
import arcomat.check.law.Suppressions;
import arcomat.check.walk.Listeners.Listener;
import arcomat.symbols.Workspace;
import arcomat.symbols.bodies.AutomatonSymbol;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.StreamTestSymbol;
import arcomat.symbols.bodies.TestSuiteSymbol;
import arcomat.symbols.names.DiagramSymbol;
import arcomat.tree.ClassDiagram;
import arcomat.tree.TestSuite;
import arcomat.tree.Unit;

import java.util.ArrayList;
import java.util.List;
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

    public Walk(Workspace workspace, Profile profile, Listeners listeners) {
        this.workspace = workspace;
        this.profile = profile;
        this.listeners = listeners;
        StereotypeWalk stereotypes = new StereotypeWalk(listeners, suppressions);
        this.expressions = new ExpressionWalk(listeners);
        this.behaviours = new BehaviourWalk(listeners, stereotypes, expressions);
        this.components = new ComponentWalk(listeners, stereotypes, expressions, behaviours);
    }

    /** The laws about all files together, then one step for each definition in wanted files. */
    public static List<Consumer<Walk>> steps(Workspace workspace, Predicate<Unit> wanted) {
        List<Consumer<Walk>> steps = new ArrayList<>();
        steps.add(Walk::workspace);
        for (ComponentSymbol each : workspace.topLevelComponents()) {
            add(wanted, each.unit(), walk -> walk.component(each), steps);
        }
        for (AutomatonSymbol each : workspace.bareAutomata()) {
            add(wanted, each.unit(), walk -> walk.automaton(each), steps);
        }
        for (DiagramSymbol each : workspace.diagrams()) {
            add(wanted, each.unit(), walk -> walk.diagram(each), steps);
        }
        for (TestSuiteSymbol each : workspace.testSuites()) {
            add(wanted, each.unit(), walk -> walk.suite(each), steps);
        }
        return steps;
    }

    private static void add(
            Predicate<Unit> wanted, Unit unit, Consumer<Walk> step, List<Consumer<Walk>> steps) {
        if (wanted.test(unit)) {
            steps.add(step);
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

    private void workspace() {
        for (Listener<Check.OnWorkspace> each : listeners.onWorkspace) {
            each.check().check(workspace, each.findings());
        }
    }

    private void component(ComponentSymbol component) {
        Context context = enter(component.unit());
        components.component(component, context);
        leave(context);
    }

    private void automaton(AutomatonSymbol automaton) {
        Context context = enter(automaton.unit());
        behaviours.automaton(automaton, context);
        leave(context);
    }

    private void diagram(DiagramSymbol diagram) {
        Context context = enter(diagram.unit());
        classDiagram(diagram, context);
        leave(context);
    }

    private void suite(TestSuiteSymbol suite) {
        Context context = enter(suite.unit());
        testSuite(suite, context);
        leave(context);
    }

    private Context enter(Unit unit) {
        Context context = Context.of(workspace, profile, unit);
        for (Listener<Check.OnUnit> each : listeners.onUnit) {
            each.check().check(unit, context, each.findings());
        }
        return context;
    }

    private void leave(Context context) {
        var names = expressions.takeNames();
        if (context.unit().imports().isEmpty()) {
            return;
        }
        for (Listener<Check.OnNames> each : listeners.onNames) {
            each.check().check(context.unit(), names, context, each.findings());
        }
    }

    private void classDiagram(DiagramSymbol diagram, Context context) {
        for (Listener<Check.OnClassDiagram> each : listeners.onClassDiagram) {
            each.check().check(diagram, context, each.findings());
        }
        for (ClassDiagram.TypeDefinition type : diagram.node().types()) {
            if (type instanceof ClassDiagram.ClassDefinition definition) {
                definition.superClass().ifPresent(t -> expressions.type(t, context));
                for (ClassDiagram.Attribute attribute : definition.attributes()) {
                    expressions.type(attribute.type(), context);
                }
            }
        }
    }

    private void testSuite(TestSuiteSymbol suite, Context context) {
        expressions.name(suite.node().component());
        for (Listener<Check.OnTestSuite> each : listeners.onTestSuite) {
            each.check().check(suite, context, each.findings());
        }
        expressions.all(suite.arguments(), context);
        for (TestSuite.Member member : suite.node().members()) {
            if (member instanceof TestSuite.Field field) {
                expressions.type(field.type(), context);
            }
        }
        for (StreamTestSymbol test : suite.tests()) {
            streamTest(test, context);
        }
    }

    private void streamTest(StreamTestSymbol test, Context context) {
        for (Listener<Check.OnStreamTest> each : listeners.onStreamTest) {
            each.check().check(test, context, each.findings());
        }
        for (StreamTestSymbol.StreamSymbol stream : test.streams()) {
            expressions.all(stream.messages(), context);
        }
    }
}
