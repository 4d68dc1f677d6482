package arcomat.pipeline.verdict;

import arcomat.pipeline.verdict.VerdictPlace.Kind;
import arcomat.source.Span;
import arcomat.tree.Automaton;
import arcomat.tree.Behaviour;
import arcomat.tree.Component;
import arcomat.tree.Definition;
import arcomat.tree.Element;
import arcomat.tree.IoTable;
import arcomat.tree.QualifiedName;
import arcomat.tree.TestSuite;
import arcomat.tree.Unit;

import java.util.ArrayList;
import java.util.List;

/** Finds the places of a file about which something can be asked. */
public final class VerdictPlaces {
    private final List<VerdictPlace> places = new ArrayList<>();

    private VerdictPlaces() {}

    /**
     * Of a tree that may have gaps. Whether an automaton asks something of parts is not seen here:
     * each is a requirement that may have no answer.
     */
    public static List<VerdictPlace> in(Unit unit) {
        VerdictPlaces found = new VerdictPlaces();
        // Each form has its places; a class diagram has none.
        boolean all =
                unit.definition()
                        .match(
                                new Definition.Cases<>(
                                        component -> found.add("", component),
                                        automaton -> found.addBehaviour("#0", automaton.span()),
                                        diagram -> true,
                                        found::add));
        return all ? List.copyOf(found.places) : List.of();
    }

    private boolean add(String around, Component component) {
        String name = around + component.name().text();
        for (QualifiedName refined : component.refines()) {
            add(
                    Kind.REFINEMENT,
                    name + " refines " + refined.text(),
                    refined.span(),
                    component.span());
        }
        for (Element.Invariant each : component.elements(Element.Invariant.class)) {
            add(Kind.INVARIANT, name + " " + each.name().text(), each.span(), each.span());
        }
        List<Span> behaviours = behaviours(component);
        for (int i = 0; i < behaviours.size(); i++) {
            addBehaviour(name + "#" + i, behaviours.get(i));
        }
        component.elements(Component.class).forEach(inner -> add(name + ".", inner));
        return true;
    }

    private static List<Span> behaviours(Component component) {
        List<Span> spans = new ArrayList<>();
        for (Behaviour each : component.elements(Behaviour.class)) {
            each.automata().stream().map(Automaton::span).forEach(spans::add);
        }
        component.elements(IoTable.class).stream().map(IoTable::span).forEach(spans::add);
        return spans;
    }

    private boolean addBehaviour(String name, Span span) {
        add(Kind.REQUIREMENT, name, span, span);
        add(Kind.AUTOMATON, name, span, span);
        return true;
    }

    private boolean add(TestSuite suite) {
        for (TestSuite.Member each : suite.members()) {
            if (each instanceof TestSuite.Test test) {
                add(Kind.TEST, test.name().text(), test.name().span(), test.span());
            }
        }
        return true;
    }

    private void add(Kind kind, String name, Span span, Span subject) {
        places.add(new VerdictPlace(kind, name, span, subject));
    }
}
