package arcomat.analysis.search.letter;

import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.semantics.value.InputAbstraction;
import arcomat.semantics.value.InputAbstraction.PortAbstraction;
import arcomat.semantics.value.MessageClasses;
import arcomat.semantics.value.TooManyMessages;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * One letter of each kind that somebody tells apart: few messages first, then in the order in which
 * ports and values are declared.
 */
public final class Letters {
    /** More letters than that are not tried at once. */
    static final int MOST = 1_000_000;

    private Letters() {}

    /** What is tried on a port. */
    interface Trials {
        /**
         * @param present whether there is a message for certain; else null is among the samples
         */
        List<Value> samples(int port, boolean present);
    }

    private static Trials kinds(List<Port> inputs, List<PortAbstraction> looks) {
        return (port, present) ->
                MessageClasses.of(inputs.get(port), present, looks.get(port)).samples();
    }

    /**
     * Messages by position of the input port, null for silence; not to be written to.
     *
     * @throws TooManyMessages where all messages of a port matter that has too many
     */
    public static List<Value[]> of(Component component, InputAbstraction abstraction) {
        return of(component.profile(), component.inputs(), abstraction.looks());
    }

    /**
     * Letters of a slice, at most so many.
     *
     * @param looks one per input port
     * @throws TooManyMessages where there are more, or all messages of a port matter that has too
     *     many
     */
    public static List<Value[]> atMost(int most, List<Port> inputs, List<PortAbstraction> looks) {
        List<Value[]> letters = slices(inputs, kinds(inputs, looks), most);
        letters.sort(Comparator.comparingInt(Letters::messages));
        return letters;
    }

    static List<Value[]> of(
            Component.Profile profile, List<Port> inputs, List<PortAbstraction> looks) {
        return of(profile, inputs, kinds(inputs, looks));
    }

    static List<Value[]> of(Component.Profile profile, List<Port> inputs, Trials trials) {
        List<Value[]> letters =
                profile == Component.Profile.EVENT_DRIVEN
                        ? events(inputs, trials)
                        : slices(inputs, trials, MOST);
        letters.sort(Comparator.comparingInt(Letters::messages));
        return letters;
    }

    /** Each port may carry a message. */
    private static List<Value[]> slices(List<Port> inputs, Trials trials, int most) {
        List<Value[]> letters = new ArrayList<>();
        letters.add(new Value[inputs.size()]);
        for (int port = 0; port < inputs.size(); port++) {
            letters = with(port, inputs.get(port).total(), letters, trials, most);
        }
        return letters;
    }

    /** One port has an event, and latched ports may have got a message before. */
    private static List<Value[]> events(List<Port> inputs, Trials trials) {
        List<Value[]> letters = new ArrayList<>();
        for (int port = 0; port < inputs.size(); port++) {
            if (!inputs.get(port).latched()) {
                Value[] silence = new Value[inputs.size()];
                letters.addAll(with(port, true, List.<Value[]>of(silence), trials, MOST));
            }
        }
        for (int port = 0; port < inputs.size(); port++) {
            if (inputs.get(port).latched()) {
                letters = with(port, false, letters, trials, MOST);
            }
        }
        return letters;
    }

    private static List<Value[]> with(
            int port, boolean present, List<Value[]> letters, Trials trials, int most) {
        List<Value> samples = trials.samples(port, present);
        if ((long) letters.size() * samples.size() > most) {
            throw TooManyMessages.together(most);
        }
        List<Value[]> longer = new ArrayList<>(letters.size() * samples.size());
        for (Value[] letter : letters) {
            for (Value sample : samples) {
                Value[] copy = letter.clone();
                copy[port] = sample;
                longer.add(copy);
            }
        }
        return longer;
    }

    /**
     * The inputs of a comparison: where the right side gets a message in every slice, nothing is
     * said about silence.
     */
    public static List<Port> compared(List<Port> left, List<Port> right) {
        Set<String> total =
                right.stream().filter(Port::total).map(Port::name).collect(Collectors.toSet());
        return left.stream()
                .map(port -> total.contains(port.name()) ? port.asTotal() : port)
                .toList();
    }

    /** How many ports carry a message. */
    public static int messages(Value[] letter) {
        int count = 0;
        for (Value message : letter) {
            count += message == null ? 0 : 1;
        }
        return count;
    }
}
