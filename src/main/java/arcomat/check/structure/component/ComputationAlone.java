package arcomat.check.structure.component;

import arcomat.check.law.Check;
import arcomat.source.Span;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.tree.Behaviour;
import arcomat.tree.Behaviour.Computation;
import arcomat.tree.Element;

import java.util.List;
import java.util.Optional;

/**
 * ARC0143: what a component computes in each slice is all that it does, and {@code init} is how
 * that begins.
 */
public final class ComputationAlone implements Check.OnComponent {

    @Override
    public void check(ComponentSymbol component, Context context, Findings findings) {
        Optional<Computation> computation =
                component.node().elements(Computation.class).stream().findFirst();
        computation.ifPresent(first -> others(first, component, findings));
        computation.ifPresent(first -> inherited(first, component, findings));
        starts(computation.isPresent(), component, findings);
    }

    private static void others(
            Computation computation, ComponentSymbol component, Findings findings) {
        for (Behaviour each : component.node().elements(Behaviour.class)) {
            if (each != computation) {
                boolean twice = each instanceof Computation;
                findings.report(
                                twice ? word(each.span(), "compute") : each.span().firstLine(),
                                twice
                                        ? "component '%s' computes twice in a slice; write all"
                                                + " statements into one 'compute'"
                                        : "'compute' says all that component '%s' does, so nothing"
                                                + " stands beside it; write one of the two",
                                component.name())
                        .related(word(computation.span(), "compute"), "computed here");
            }
        }
    }

    /** A computation may take the place of another one. */
    private static void inherited(
            Computation computation, ComponentSymbol component, Findings findings) {
        for (ComponentSymbol ancestor : component.lineage()) {
            Optional<Behaviour> behaviour =
                    ancestor.node().elements(Behaviour.class).stream()
                            .filter(each -> !(each instanceof Computation))
                            .findFirst();
            if (ancestor != component && behaviour.isPresent()) {
                findings.report(
                                word(computation.span(), "compute"),
                                "'compute' says all that component '%s' does, but it inherits what"
                                        + " '%s' does; write one of the two",
                                component.name(),
                                ancestor.name())
                        .related(behaviour.get().span().firstLine(), "inherited from here");
                return;
            }
        }
    }

    private static void starts(boolean computes, ComponentSymbol component, Findings findings) {
        List<Element.Start> starts = component.node().elements(Element.Start.class);
        if (!computes && !starts.isEmpty()) {
            findings.report(
                    word(starts.get(0).span(), "init"),
                    "'init' is how a 'compute' begins, and there is none; an automaton has"
                            + " 'initial state / do {..};'");
        }
        for (Element.Start each : starts.subList(Math.min(1, starts.size()), starts.size())) {
            findings.report(
                            word(each.span(), "init"),
                            "component '%s' begins twice; write all statements into one 'init'",
                            component.name())
                    .related(word(starts.get(0).span(), "init"), "the first one");
        }
    }

    /** The first place of a word in what is written. */
    private static Span word(Span span, String word) {
        int start = span.start() + Math.max(0, span.text().indexOf(word));
        return span.file().span(start, start + word.length());
    }
}
