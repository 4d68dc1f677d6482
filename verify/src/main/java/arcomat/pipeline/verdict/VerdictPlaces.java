package arcomat.pipeline.verdict;

import arcomat.pipeline.verdict.VerdictPlace.Kind;
import arcomat.source.Span;
import arcomat.tree.Automaton;
import arcomat.tree.Behaviour;
import arcomat.tree.Component;
import arcomat.tree.Definition;
import arcomat.tree.Element;
import arcomat.tree.Stereotype;
import arcomat.tree.TestSuite;
import arcomat.tree.Unit;

import java.util.ArrayList;
import java.util.List;

/** The places of a file about which something can be asked. */
public final class VerdictPlaces {
    private static final String DEPLOY = "deploy";

    private VerdictPlaces() {}

    /**
     * Of a tree that may have gaps. Whether an automaton asks something of parts is not seen here,
     * nor whether one is inherited that does: each is a requirement that may have no answer.
     */
    public static List<VerdictPlace> in(Unit unit) {
        return unit.definition()
                .match(
                        new Definition.Cases<>(
                                component -> in(component, ""),
                                automaton -> of(automaton.span(), "#0"),
                                diagram -> List.of(),
                                VerdictPlaces::in));
    }

    /**
     * @param around the names of the components around it, with a dot behind each
     */
    private static List<VerdictPlace> in(Component component, String around) {
        String name = around + component.name().text();
        List<VerdictPlace> places = new ArrayList<>();
        if (component.isDeploy() || Stereotype.find(component.stereotypes(), DEPLOY).isPresent()) {
            places.add(
                    new VerdictPlace(
                            Kind.PROGRAM, name, component.name().span(), component.span()));
        }
        component
                .superComponent()
                .map(
                        above ->
                                new VerdictPlace(
                                        Kind.INHERITED, name, above.span(), component.span()))
                .ifPresent(places::add);
        for (Component.Refined each : component.refined()) {
            places.add(
                    new VerdictPlace(
                            Kind.REFINEMENT,
                            name + " refines " + text(each),
                            each.name().span(),
                            component.span()));
        }
        for (Element.Invariant each : component.elements(Element.Invariant.class)) {
            String invariant = name + " " + each.name().text();
            places.add(new VerdictPlace(Kind.INVARIANT, invariant, each.span(), each.span()));
        }
        List<Span> behaviours = behaviours(component);
        for (int i = 0; i < behaviours.size(); i++) {
            places.addAll(of(behaviours.get(i), name + "#" + i));
        }
        for (Component inner : component.elements(Component.class)) {
            places.addAll(in(inner, name + "."));
        }
        return places;
    }

    /** With the features that are chosen: another choice is another promise. */
    private static String text(Component.Refined refined) {
        List<String> chosen = refined.arguments().stream().map(each -> each.span().text()).toList();
        return refined.name().text() + (chosen.isEmpty() ? "" : chosen.toString());
    }

    /** Automata, and what becomes one where names are known. */
    private static List<Span> behaviours(Component component) {
        List<Span> spans = new ArrayList<>();
        for (Behaviour each : component.elements(Behaviour.class)) {
            if (each instanceof Behaviour.Foreign) {
                spans.add(each.span());
            } else {
                each.automata().stream().map(Automaton::span).forEach(spans::add);
            }
        }
        return spans;
    }

    private static List<VerdictPlace> of(Span behaviour, String name) {
        return List.of(
                new VerdictPlace(Kind.REQUIREMENT, name, behaviour, behaviour),
                new VerdictPlace(Kind.AUTOMATON, name, behaviour, behaviour));
    }

    private static List<VerdictPlace> in(TestSuite suite) {
        return suite.members().stream()
                .filter(TestSuite.Test.class::isInstance)
                .map(TestSuite.Test.class::cast)
                .map(
                        test ->
                                new VerdictPlace(
                                        Kind.TEST,
                                        test.name().text(),
                                        test.name().span(),
                                        test.span()))
                .toList();
    }
}
