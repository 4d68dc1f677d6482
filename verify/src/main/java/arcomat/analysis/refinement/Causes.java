package arcomat.analysis.refinement;

import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Trace;
import arcomat.semantics.Promise;
import arcomat.semantics.network.Network;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;

/** Says what the automata of one side did in a step. */
record Causes(Promise promise) {

    /**
     * @param causes of a composition in slices one per automaton of its parts, in their order; with
     *     events in the order in which they happened
     */
    List<String> words(List<Trace.Cause> causes) {
        List<String> words = new ArrayList<>();
        for (int i = 0; i < causes.size(); i++) {
            words.add(
                    causes.get(i) instanceof Trace.Taken taken
                            ? words(taken)
                            : words((Trace.Completed) causes.get(i), i));
        }
        return words;
    }

    private String words(Trace.Taken taken) {
        return promise.isComposition()
                ? ofPart(promise.component(), taken).orElse("transition of a part")
                : among(promise.automata(), taken).orElse("transition");
    }

    private String words(Trace.Completed completed, int position) {
        String part = promise.isComposition() ? part(completed, position) : "";
        return "no transition "
                + (part.isEmpty() ? "" : "of " + part + " ")
                + "fits, completion "
                + completed.completion().name().toLowerCase(Locale.ROOT);
    }

    /** By its path, where that is sure; of events it is not known which part has handled them. */
    private String part(Trace.Completed completed, int position) {
        List<Network.Instance> parts = promise.network().instances();
        if (promise.component().profile() == Component.Profile.TIME_SYNCHRONOUS) {
            List<String> paths =
                    parts.stream()
                            .flatMap(
                                    part ->
                                            part.component().automata().stream()
                                                    .map(any -> part.path()))
                            .toList();
            return position < paths.size() ? paths.get(position) : "a part";
        }
        List<String> able =
                parts.stream()
                        .filter(part -> completes(part.component(), completed))
                        .map(Network.Instance::path)
                        .toList();
        return able.size() == 1 ? able.get(0) : "a part";
    }

    private static boolean completes(Component part, Trace.Completed completed) {
        return part.automata().stream().anyMatch(a -> a.completion() == completed.completion());
    }

    private static Optional<String> among(List<Automaton> automata, Trace.Taken taken) {
        return automata.stream()
                .filter(a -> taken.index() < a.transitions().size())
                .filter(a -> a.transitions().get(taken.index()).equals(taken.transition()))
                .findFirst()
                .map(a -> "transition " + states(a, taken.transition()));
    }

    private static String states(Automaton automaton, Automaton.Transition transition) {
        return automaton.states().get(transition.source())
                + " -> "
                + automaton.states().get(transition.target());
    }

    private static Optional<String> ofPart(Component component, Trace.Taken taken) {
        if (component.body() instanceof Component.Atomic atomic) {
            return among(atomic.automata(), taken).map(t -> t + " of " + component.name());
        }
        Stream<Component> parts =
                ((Component.Composite) component.body()).parts().stream().map(p -> p.component());
        return parts.flatMap(part -> ofPart(part, taken).stream()).findFirst();
    }
}
