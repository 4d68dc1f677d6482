package arcomat.analysis.refinement;

import arcomat.analysis.refinement.Verdict.Sentence;
import arcomat.analysis.search.Moment;
import arcomat.analysis.search.product.Counterexample.Forbidden;
import arcomat.model.Component;
import arcomat.model.Invariant;
import arcomat.model.Trace;
import arcomat.semantics.Promise;
import arcomat.semantics.expression.Sent;
import arcomat.semantics.invariant.InvariantWatch;
import arcomat.semantics.invariant.InvariantWatch.Truth;
import arcomat.semantics.network.Network;
import arcomat.source.Span;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;

/** A run in which an invariant is broken, as one who looks at the component sees it. */
final class InvariantCounterexample {
    private final Component component;
    private final Promise together;
    private final InvariantWatch watch;
    private final Network network;
    private final Set<String> late;

    /**
     * @param together the component beside the observer
     */
    InvariantCounterexample(Component component, Promise together, InvariantWatch watch) {
        this.component = component;
        this.together = together;
        this.watch = watch;
        this.network = together.network();
        Set<Integer> delayed = network.delayed();
        this.late =
                network.outputs().stream()
                        .filter(port -> delayed.contains(port.signal()))
                        .map(Network.External::name)
                        .collect(Collectors.toSet());
    }

    static String word(Truth truth) {
        return truth == Truth.FALSE ? "false" : "undefined";
    }

    /**
     * What was to be seen, slice by slice.
     *
     * @param moments inputs with the reactions to them, the beginning first
     */
    List<Moment> slices(List<Moment> moments) {
        List<Moment> slices = new ArrayList<>();
        for (int i = 1; i < moments.size(); i++) {
            Map<String, Sent> earlier = moments.get(i - 1).outputs();
            Map<String, Sent> seen = new LinkedHashMap<>();
            moments.get(i)
                    .outputs()
                    .forEach(
                            (port, sent) ->
                                    seen.put(port, late.contains(port) ? earlier.get(port) : sent));
            seen.remove(InvariantWatch.BROKEN);
            Moment moment = moments.get(i);
            List<String> truth = i == moments.size() - 1 ? List.of() : List.of("true");
            slices.add(new Moment(moment.input(), seen, own(moment.left()), truth));
        }
        return slices;
    }

    /** Without the observer; a component without parts is not told from itself. */
    private String own(String words) {
        String observer = watch.name() + ": " + InvariantWatch.STATE;
        String rest =
                words.replace(", " + observer, "")
                        .replace(observer + ", ", "")
                        .replace(observer, "");
        String name = component.name() + ": ";
        return component.isComposite() || !rest.startsWith(name)
                ? rest
                : rest.substring(name.length());
    }

    /** Why the last slice breaks it. */
    List<Sentence> explanation(Invariant invariant, Forbidden forbidden, List<Moment> slices) {
        int observer = positionOfObserver();
        Truth truth = InvariantWatch.truth(forbidden.causes().get(observer));
        int slice = slices.size() - 1;
        String text =
                "In slice %d invariant '%s' is %s%s"
                        .formatted(
                                slice,
                                invariant.name(),
                                word(truth),
                                truth == Truth.UNDEFINED ? silence(slices.get(slice)) : "");
        List<Sentence> sentences = new ArrayList<>();
        sentences.add(new Sentence(text, Optional.of(invariant.condition().span())));
        if (isAboutTheReaction()) {
            sentences.addAll(reaction(forbidden, observer));
        }
        return sentences;
    }

    /** The position of what the observer did: parts come with one cause per automaton. */
    private int positionOfObserver() {
        int position = 0;
        for (Network.Instance part : network.instances()) {
            if (part.path().equals(watch.name())) {
                return position;
            }
            position += part.component().automata().size();
        }
        throw new AssertionError("no observer");
    }

    private String silence(Moment last) {
        List<String> silent =
                watch.seen().stream()
                        .filter(InvariantWatch.SeenPort.class::isInstance)
                        .map(each -> each.input().name())
                        .filter(port -> isSilent(port, last))
                        .map(port -> "'" + port + "'")
                        .toList();
        if (silent.isEmpty()) {
            return ": a message is missing that it reads, or a divisor is zero";
        }
        return ": there is no message on "
                + String.join(", ", silent)
                + " (an invariant says what silence means with == --)";
    }

    private static boolean isSilent(String port, Moment last) {
        Sent sent = last.outputs().get(port);
        return sent == null ? last.input().message(port).isEmpty() : sent.equals(Sent.SILENCE);
    }

    /** Whether it mentions what the component does in the same slice. */
    private boolean isAboutTheReaction() {
        return watch.seen().stream()
                .anyMatch(
                        each ->
                                !(each instanceof InvariantWatch.SeenPort)
                                        || !component.port(each.input().name()).get().isInput()
                                                && !late.contains(each.input().name()));
    }

    private List<Sentence> reaction(Forbidden forbidden, int observer) {
        List<Trace.Cause> causes = forbidden.causes();
        List<String> words = new Causes(together).words(causes);
        List<Sentence> sentences = new ArrayList<>();
        for (int i = 0; i < causes.size(); i++) {
            if (i != observer) {
                Optional<Span> place =
                        causes.get(i) instanceof Trace.Taken taken
                                ? Optional.ofNullable(taken.transition().span())
                                : Optional.empty();
                sentences.add(new Sentence(words.get(i), place));
            }
        }
        return sentences;
    }
}
