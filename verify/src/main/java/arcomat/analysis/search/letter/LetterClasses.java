package arcomat.analysis.search.letter;

import arcomat.analysis.search.Budget;
import arcomat.analysis.search.Numbering;
import arcomat.analysis.search.Shortcut;
import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.semantics.value.InputAbstraction;
import arcomat.semantics.value.InputAbstraction.PortAbstraction;
import arcomat.semantics.value.InputAbstraction.Whole;
import arcomat.semantics.value.MessageClasses;
import arcomat.semantics.value.SmallType;
import arcomat.semantics.value.TooManyMessages;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.IntFunction;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;

/**
 * The classes of letters that a configuration tells apart: all letters of one class have the same
 * steps. The classes are the minterms of what is looked at (symbolic automata: D'Antoni, Veanes,
 * "Minimization of symbolic automata", POPL 2014).
 */
public final class LetterClasses {
    /** Kinds of the other ports, and messages that are told apart one by one. */
    private record Told(long kind, List<Value> messages) {}

    private final int number;
    private final InputAbstraction abstraction;
    private final MessageClasses[] kinds;
    private final int[] ports;
    private final int[] identity;
    private final long[] strides;

    /** Ports of too many values to be numbered beforehand. */
    private final int[] copied;

    private final Numbering<Told> told = new Numbering<>();

    public LetterClasses(int number, InputAbstraction abstraction, List<Port> inputs) {
        this.number = number;
        this.abstraction = abstraction;
        this.identity = IntStream.range(0, inputs.size()).toArray();
        List<PortAbstraction> looks = abstraction.looks();
        kinds = new MessageClasses[inputs.size()];
        strides = new long[inputs.size()];
        long stride = 1;
        int seen = 0;
        int[] all = new int[inputs.size()];
        for (int i = 0; i < kinds.length; i++) {
            kinds[i] = MessageClasses.of(inputs.get(i), false, told(inputs.get(i), looks.get(i)));
            strides[i] = stride;
            stride = product(stride, kinds[i].count());
            if (kinds[i].count() > 1) {
                all[seen++] = i;
            }
        }
        ports = Arrays.copyOf(all, seen);
        copied =
                IntStream.range(0, inputs.size())
                        .filter(i -> isTold(inputs.get(i), looks.get(i)))
                        .toArray();
    }

    /** Nobody tries more letters than can be numbered. */
    private static long product(long stride, int count) {
        if (stride > Long.MAX_VALUE / count) {
            throw TooManyMessages.together(Letters.MOST);
        }
        return stride * count;
    }

    private static boolean isTold(Port port, PortAbstraction look) {
        boolean each = look instanceof InputAbstraction.Copied || look instanceof Whole;
        return each && SmallType.values(port.type()).isEmpty();
    }

    private static PortAbstraction told(Port port, PortAbstraction look) {
        return isTold(port, look) ? new InputAbstraction.Unseen() : look;
    }

    /**
     * Whether messages are told apart one by one that are too many to try, and more is done with
     * them than to compare them with each other.
     *
     * @param isFree whether of a port's data it only matters which are the same
     */
    public boolean calculates(IntPredicate isFree) {
        for (int port : copied) {
            if (!isFree.test(port) || abstraction.looks().get(port) instanceof Whole) {
                return true;
            }
        }
        return false;
    }

    /** LetterClassesPool of one side are numbered from 0. */
    public int number() {
        return number;
    }

    /** What is looked at, port by port. */
    public InputAbstraction abstraction() {
        return abstraction;
    }

    /** The class of a letter of this system's own ports. */
    public long kind(Value[] letter) {
        return kind(letter, identity);
    }

    /**
     * The class of a letter.
     *
     * @param letter messages by position
     * @param positions where the ports of this system stand in the letter
     */
    public long kind(Value[] letter, int[] positions) {
        long kind = 0;
        for (int port : ports) {
            kind += strides[port] * kinds[port].of(letter[positions[port]]);
        }
        return copied.length == 0 ? kind : told(kind, letter, positions);
    }

    private long told(long kind, Value[] letter, int[] positions) {
        List<Value> messages = new ArrayList<>(copied.length);
        for (int port : copied) {
            messages.add(letter[positions[port]]);
        }
        return told.number(new Told(kind, messages));
    }

    /** The classes for each configuration of one system; the same for all that look at the same. */
    public static final class OfConfigurations {
        private final List<Port> inputs;
        private final Budget budget;
        private final Map<InputAbstraction, LetterClasses> distinct = new HashMap<>();
        private final List<LetterClasses> known = new ArrayList<>();

        public OfConfigurations(List<Port> inputs, Budget budget) {
            this.inputs = inputs;
            this.budget = budget;
        }

        /**
         * @param abstraction of inputs in a configuration, asked once for each
         */
        public LetterClasses of(int configuration, IntFunction<InputAbstraction> abstraction) {
            while (known.size() <= configuration) {
                known.add(null);
            }
            LetterClasses classes = known.get(configuration);
            if (classes == null) {
                classes = of(abstraction.apply(configuration));
                known.set(configuration, classes);
            }
            return classes;
        }

        private LetterClasses of(InputAbstraction abstraction) {
            return distinct.computeIfAbsent(
                    abstraction, each -> new LetterClasses(distinct.size(), paid(each), inputs));
        }

        private InputAbstraction paid(InputAbstraction abstraction) {
            InputAbstraction all = new InputAbstraction(all(abstraction));
            boolean alike = !abstraction.equals(all) && budget.takes(Shortcut.ALIKE);
            return alike ? abstraction : all;
        }

        /** A look at every single message, where these can be tried. */
        private List<PortAbstraction> all(InputAbstraction abstraction) {
            List<PortAbstraction> looks = new ArrayList<>();
            for (int port = 0; port < inputs.size(); port++) {
                boolean few = SmallType.values(inputs.get(port).type()).isPresent();
                looks.add(few ? new Whole() : abstraction.looks().get(port));
            }
            return looks;
        }
    }
}
