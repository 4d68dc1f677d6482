package arcomat.analysis.game;

import arcomat.analysis.search.Budget;
import arcomat.analysis.search.IntKey;
import arcomat.analysis.search.Numbering;
import arcomat.analysis.search.step.OutputCubes;
import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.semantics.expression.Output;
import arcomat.semantics.expression.Sent;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * What a system may send so that each of several requirements allows it. Only outputs that matter
 * are listed: one that fewer steps allow than another leaves the requirements fewer ways to go on,
 * and is never better.
 */
public final class Choices {
    /**
     * One output.
     *
     * @param sent a cube: where a port is left open, every message will do
     * @param allowed per list of cubes the positions of those that allow it
     */
    record Choice(Output sent, int[][] allowed) {}

    private final List<Port> ports;
    private final OutputCubes outputs;
    private final Budget budget;
    private final Numbering<IntKey> lists = new Numbering<>();
    private final Map<IntKey, List<Choice>> known = new HashMap<>();

    /**
     * @param ports the output ports, as cubes list them
     * @param budget of time and memory
     */
    public Choices(List<Port> ports, OutputCubes outputs, Budget budget) {
        this.budget = budget;
        this.ports = ports;
        this.outputs = outputs;
    }

    List<Port> ports() {
        return ports;
    }

    @Nullable Output cube(int number) {
        return outputs.cube(number);
    }

    /** Whether each list allows an error. */
    boolean mayEnd(int[] demands) {
        return Arrays.stream(demands)
                .allMatch(each -> Arrays.stream(list(each)).anyMatch(c -> !outputs.isLetter(c)));
    }

    /** The number of a list of cubes. */
    int number(int[] cubes) {
        return lists.number(new IntKey(cubes));
    }

    private int[] list(int number) {
        return lists.get(number).all();
    }

    /** Whether whatever one list allows is also allowed by another. */
    boolean isWeaker(int list, int other) {
        return Arrays.stream(list(other))
                .allMatch(
                        inner ->
                                Arrays.stream(list(list))
                                        .anyMatch(outer -> contains(outer, inner)));
    }

    private boolean contains(int outer, int inner) {
        return outer == inner
                || outputs.isLetter(outer)
                        && outputs.isLetter(inner)
                        && outputs.letter(outer)
                                .meet(outputs.letter(inner))
                                .equals(Optional.of(outputs.letter(inner)));
    }

    /**
     * All outputs that matter, in the order in which they are mentioned; none where the
     * requirements contradict each other, unless all of them allow an error.
     *
     * @param demands numbers of lists of cubes, one per requirement
     */
    List<Choice> of(int[] demands) {
        IntKey key = new IntKey(demands);
        List<Choice> found = known.get(key);
        if (found == null) {
            found = compute(demands);
            known.put(key, found);
        }
        return found;
    }

    private List<Choice> compute(int[] demands) {
        List<Choice> found = new ArrayList<>();
        int[][] letters = new int[demands.length][];
        for (int i = 0; i < demands.length; i++) {
            letters[i] = letters(list(demands[i]));
        }
        if (allPossible(letters)) {
            choose(demands, letters, new ArrayList<>(), found, new HashSet<>());
        }
        return List.copyOf(found);
    }

    private int[] letters(int[] cubes) {
        int[] all = new int[cubes.length];
        int count = 0;
        for (int i = 0; i < cubes.length; i++) {
            if (outputs.isLetter(cubes[i])) {
                all[count++] = i;
            }
        }
        return Arrays.copyOf(all, count);
    }

    private static boolean allPossible(int[][] allowed) {
        return Arrays.stream(allowed).allMatch(each -> each.length > 0);
    }

    /** Port by port; what is left of each requirement's cubes must not become empty. */
    private void choose(
            int[] demands,
            int[][] allowed,
            List<Sent> sent,
            List<Choice> found,
            Set<List<Integer>> seen) {
        budget.insist();
        int port = sent.size();
        if (port == ports.size()) {
            List<Integer> flat = new ArrayList<>();
            for (int[] each : allowed) {
                flat.add(-1);
                Arrays.stream(each).forEach(flat::add);
            }
            if (seen.add(flat)) {
                found.add(new Choice(new Output(sent), allowed));
            }
            return;
        }
        for (Sent option : options(demands, allowed, port)) {
            int[][] rest = new int[demands.length][];
            for (int i = 0; i < demands.length; i++) {
                rest[i] = allowing(list(demands[i]), allowed[i], port, option);
            }
            if (allPossible(rest)) {
                List<Sent> longer = new ArrayList<>(sent);
                longer.add(option);
                choose(demands, rest, longer, found, seen);
            }
        }
    }

    private int[] allowing(int[] cubes, int[] allowed, int port, Sent option) {
        int[] rest = new int[allowed.length];
        int count = 0;
        for (int position : allowed) {
            if (outputs.letter(cubes[position]).ports().get(port).meet(option).isPresent()) {
                rest[count++] = position;
            }
        }
        return count == allowed.length ? allowed : Arrays.copyOf(rest, count);
    }

    /** What is mentioned for a port; where nothing is, what all leave open. */
    private Set<Sent> options(int[] demands, int[][] allowed, int port) {
        Set<Sent> options = new LinkedHashSet<>();
        boolean some = false;
        for (int i = 0; i < demands.length; i++) {
            int[] cubes = list(demands[i]);
            for (int position : allowed[i]) {
                Sent sent = outputs.letter(cubes[position]).ports().get(port);
                if (sent instanceof Sent.Messages) {
                    options.add(sent);
                }
                some |= sent instanceof Sent.AnyMessage;
            }
        }
        boolean one = options.stream().anyMatch(each -> new Sent.AnyMessage().allows(values(each)));
        if (some && !one) {
            options.add(new Sent.AnyMessage());
        }
        if (options.isEmpty()) {
            options.add(new Sent.Anything());
        }
        return options;
    }

    private static List<Value> values(Sent sent) {
        return ((Sent.Messages) sent).values();
    }
}
