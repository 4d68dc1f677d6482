package arcomat.laws.draw;

import arcomat.model.Automaton;
import arcomat.model.Automaton.Transition;
import arcomat.model.Component;
import arcomat.model.Model;
import arcomat.source.Span;

import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The ranks of transitions. Only guests can say them, so random models have them in comments in
 * front of transitions.
 */
public final class Ranks {
    private static final Pattern RANK = Pattern.compile("/\\* rank ([0-9]) \\*/ *$");

    private final Map<Component, Component> known = new IdentityHashMap<>();

    private Ranks() {}

    static String text(int rank) {
        return "/* rank %d */ ".formatted(rank);
    }

    /** The models with the ranks that their texts tell. */
    public static Model of(Model model) {
        Ranks ranks = new Ranks();
        return new Model(model.components().stream().map(ranks::of).toList(), model.tests());
    }

    private Component of(Component component) {
        Component found = known.get(component);
        if (found == null) {
            found = ranked(component);
            known.put(component, found);
        }
        return found;
    }

    private Component ranked(Component component) {
        return new Component(
                component.packageName(),
                component.name(),
                component.layer(),
                component.platform(),
                component.deploy(),
                component.profile(),
                component.queueCapacity(),
                component.cycle(),
                component.parameters(),
                component.constants(),
                component.ports(),
                body(component.body()),
                automata(component.requirements()),
                component.refines(),
                component.invariants(),
                component.span());
    }

    private Component.Body body(Component.Body body) {
        if (body instanceof Component.Atomic atomic) {
            return new Component.Atomic(automata(atomic.automata()), atomic.shown());
        }
        Component.Composite whole = (Component.Composite) body;
        return new Component.Composite(
                whole.parts().stream()
                        .map(
                                part ->
                                        new Component.Part(
                                                part.name(),
                                                of(part.component()),
                                                part.arguments(),
                                                part.span()))
                        .toList(),
                whole.connections());
    }

    private static List<Automaton> automata(List<Automaton> automata) {
        return automata.stream()
                .map(
                        each ->
                                each.withTransitions(
                                        each.transitions().stream().map(Ranks::of).toList()))
                .toList();
    }

    private static Transition of(Transition transition) {
        Span place = transition.span();
        String before = place.file().text().substring(0, place.start());
        Matcher rank = RANK.matcher(before.substring(before.lastIndexOf('\n') + 1));
        return transition.withRank(rank.find() ? Integer.parseInt(rank.group(1)) : 0);
    }
}
