package arcomat.check.structure.component;

import arcomat.check.law.Check;
import arcomat.source.Span;
import arcomat.symbols.bodies.AutomatonSymbol;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.tree.Name;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/**
 * ARC0126: before code is made, an atomic component has one behaviour. Several are requirements
 * that hold together, and none of them says what to do. (Wor16 MU2)
 */
public final class SingleAutomaton implements Check.OnComponent {

    @Override
    public void check(ComponentSymbol component, Context context, Findings findings) {
        if (component.isDecomposed()) {
            return;
        }
        List<Span> behaviours = behaviours(component);
        for (Span behaviour :
                behaviours.subList(Math.min(1, behaviours.size()), behaviours.size())) {
            findings.report(
                            behaviour,
                            "component '%s' has %s behaviours; code is made from one: write one"
                                + " that satisfies them all, in a component that refines this one",
                            component.name(),
                            behaviours.size())
                    .related(behaviours.get(0), "the first behaviour");
        }
    }

    /** Where the behaviours of a component begin, in text order. */
    private static List<Span> behaviours(ComponentSymbol component) {
        List<Span> places = new ArrayList<>();
        for (AutomatonSymbol automaton : component.ownAutomata()) {
            Span all = automaton.node().span();
            places.add(automaton.node().name().map(Name::span).orElseGet(() -> firstWord(all)));
        }
        places.sort(Comparator.comparingInt(Span::start));
        return places;
    }

    private static Span firstWord(Span span) {
        int end = span.start();
        while (end < span.end() && Character.isLetter(span.file().text().charAt(end))) {
            end++;
        }
        return new Span(span.file(), span.start(), Math.max(end, span.start() + 1));
    }
}
