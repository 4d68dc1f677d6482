package arcomat.analysis.search.step;

import arcomat.analysis.search.Budget;
import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.semantics.expression.Output;
import arcomat.semantics.expression.Sent;
import arcomat.semantics.value.ValueGaps;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.Comparator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;

/**
 * Divides what one step may send by what the steps of the other side allow: letters within one case
 * are allowed by the same steps. Only ports that are left open are divided, and only by the values
 * that the other side mentions.
 */
public final class CubeSplit {

    /**
     * @param sample one of its letters
     * @param messages how many the sample has
     * @param allowed positions of the steps that allow it
     * @param error whether the run ends here; the sample is what earlier reactions still show
     */
    public record Case(Output sample, int messages, int[] allowed, boolean error) {}

    private final List<Port> ports;
    private final OutputCubes outputs;
    private final boolean events;
    private final Budget budget;
    private final Output silence;

    /**
     * @param ports the observed output ports
     * @param events whether a port may send several messages at once
     */
    public CubeSplit(List<Port> ports, OutputCubes outputs, boolean events, Budget budget) {
        this.budget = budget;
        this.events = events;
        this.ports = ports;
        this.outputs = outputs;
        this.silence = new Output(Collections.nCopies(ports.size(), Sent.SILENCE));
    }

    /** The cases, those with few messages first. */
    public List<Case> cases(int sent, int[] others) {
        boolean error = !outputs.isLetter(sent);
        int[] alike = alike(others, error);
        Output cube = shown(sent);
        List<Set<Sent>> options = new ArrayList<>();
        for (int port = 0; port < ports.size(); port++) {
            options.add(options(cube.ports().get(port), port, alike));
        }
        List<List<Sent>> letters = combinations(options, budget);
        List<Case> cases = new ArrayList<>();
        for (List<Sent> letter : letters) {
            budget.insist();
            Output sample = new Output(letter);
            int[] allowed = positions(others, sample, error);
            cases.add(new Case(sample, messages(sample), allowed, error));
        }
        cases.sort(Comparator.comparingInt(Case::messages));
        return cases;
    }

    /** One option of each port, in all combinations; those of the first port change fastest. */
    public static List<List<Sent>> combinations(
            List<? extends Collection<Sent>> options, Budget budget) {
        List<List<Sent>> combinations = List.of(List.of());
        for (Collection<Sent> ofPort : options) {
            List<List<Sent>> longer = new ArrayList<>();
            for (Sent option : ofPort) {
                for (List<Sent> each : combinations) {
                    budget.insist();
                    List<Sent> copy = new ArrayList<>(each);
                    copy.add(option);
                    longer.add(copy);
                }
            }
            combinations = longer;
        }
        return combinations;
    }

    private Set<Sent> options(Sent sent, int port, int[] others) {
        Set<Sent> options = new LinkedHashSet<>();
        if (sent instanceof Sent.Messages) {
            options.add(sent);
            return options;
        }
        if (sent.allows(List.of())) {
            options.add(Sent.SILENCE);
        }
        List<Value> mentioned = new ArrayList<>();
        for (int other : others) {
            if (shown(other).ports().get(port) instanceof Sent.Messages messages
                    && sent.allows(messages.values())) {
                options.add(messages);
                mentioned.addAll(messages.values());
            }
        }
        List<Value> fresh = new ValueGaps(ports.get(port).type(), sorted(mentioned)).any();
        fresh.forEach(value -> options.add(new Sent.Messages(List.of(value))));
        if (events && sent instanceof Sent.Anything) {
            options.add(longer(port, options));
        }
        return options;
    }

    /** Event-driven, a port may send more messages than any that are mentioned. */
    private Sent longer(int port, Set<Sent> options) {
        int longest = 0;
        for (Sent option : options) {
            longest = Math.max(longest, ((Sent.Messages) option).values().size());
        }
        Value value = ports.get(port).type().first();
        return new Sent.Messages(Collections.nCopies(longest + 1, value));
    }

    private static List<Value> sorted(List<Value> values) {
        return values.stream().distinct().sorted().toList();
    }

    /** Those that end the run, or those that do not. */
    private int[] alike(int[] others, boolean error) {
        return IntStream.of(others).filter(each -> outputs.isLetter(each) != error).toArray();
    }

    private Output shown(int number) {
        return number == OutputCubes.ERROR ? silence : outputs.letter(number);
    }

    private int[] positions(int[] others, Output sample, boolean error) {
        return IntStream.range(0, others.length)
                .filter(i -> outputs.isLetter(others[i]) != error)
                .filter(i -> allows(shown(others[i]), sample))
                .toArray();
    }

    private static boolean allows(Output cube, Output letter) {
        for (int i = 0; i < letter.ports().size(); i++) {
            Sent.Messages messages = (Sent.Messages) letter.ports().get(i);
            if (!cube.ports().get(i).allows(messages.values())) {
                return false;
            }
        }
        return true;
    }

    private static int messages(Output letter) {
        int count = 0;
        for (Sent sent : letter.ports()) {
            count += ((Sent.Messages) sent).values().size();
        }
        return count;
    }
}
