package arcomat.benchmarks.compositions;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;

/**
 * A machine that reads numbers and sends one number in every slice, seen one slice later.
 *
 * @param inputs how many values each of its input ports may carry, from 0
 * @param values how many values it may send, from 0
 * @param first what it sends before it has read anything
 * @param rules for each state and each input there is one
 */
record PartKind(
        String name, List<Integer> inputs, int values, int first, int states, List<Rule> rules) {
    /** Where no rule fits, it stays in its state and sends 0. */
    static PartKind completed(
            String name,
            List<Integer> inputs,
            int values,
            int first,
            int states,
            List<Rule> rules) {
        List<Rule> all = new ArrayList<>(rules);
        for (int state = 0; state < states; state++) {
            for (List<Integer> letter : letters(inputs)) {
                int from = state;
                if (rules.stream().noneMatch(rule -> rule.fits(from, letter))) {
                    all.add(Rule.of(state, letter, new Way(state, 0)));
                }
            }
        }
        return new PartKind(name, inputs, values, first, states, all);
    }

    private static List<List<Integer>> letters(List<Integer> inputs) {
        List<List<Integer>> letters = List.of(List.of());
        for (int values : inputs) {
            List<List<Integer>> longer = new ArrayList<>();
            for (List<Integer> letter : letters) {
                for (int value = 0; value < values; value++) {
                    List<Integer> copy = new ArrayList<>(letter);
                    copy.add(value);
                    longer.add(copy);
                }
            }
            letters = longer;
        }
        return letters;
    }

    PartKind {
        inputs = List.copyOf(inputs);
        rules = List.copyOf(rules);
    }

    /**
     * @param read one per input port, the values that it may carry; empty where that is no matter
     * @param ways one is taken, whichever
     */
    record Rule(int state, List<List<Integer>> read, List<Way> ways) {
        static final int ANY = -1;

        Rule {
            read = List.copyOf(read);
            ways = List.copyOf(ways);
        }

        /**
         * @param read one per input port, the value that it carries, or {@link #ANY}
         */
        static Rule of(int state, List<Integer> read, Way... ways) {
            List<List<Integer>> values =
                    read.stream().map(v -> v == ANY ? List.<Integer>of() : List.of(v)).toList();
            return new Rule(state, values, List.of(ways));
        }

        boolean fits(int from, List<Integer> letter) {
            return state == from
                    && IntStream.range(0, read.size())
                            .allMatch(
                                    i ->
                                            read.get(i).isEmpty()
                                                    || read.get(i).contains(letter.get(i)));
        }
    }

    record Way(int state, int sends) {}

    /** The most ways that a rule leaves open. */
    int choices() {
        return rules.stream().mapToInt(rule -> rule.ways().size()).max().orElse(1);
    }
}
