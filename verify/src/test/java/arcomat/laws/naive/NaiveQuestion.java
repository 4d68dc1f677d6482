package arcomat.laws.naive;

import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Letter;
import arcomat.model.Port;
import arcomat.model.Value;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import java.util.Set;

/**
 * Whether one component shows only what another one may show, as far as trying tells. Of large
 * types, the left side sends some messages only; then a failure that is found is one, and none that
 * is found says nothing.
 */
public final class NaiveQuestion {
    private static final int MOST_PAIRS = 200;
    private static final int MOST_LETTERS = 60;

    private NaiveQuestion() {}

    /**
     * @param shortest after how many inputs it fails; empty if it does not
     * @param fitsFeedback whether the delays allow it
     * @param isComplete whether nothing was left out up to the greatest number of inputs
     * @param isUnknown where types are too large, or where there is too much to try
     */
    public record Answer(
            OptionalInt shortest, boolean fitsFeedback, boolean isComplete, boolean isUnknown) {
        private static final Answer UNKNOWN = new Answer(OptionalInt.empty(), true, false, true);

        public boolean fails() {
            return shortest.isPresent() || !fitsFeedback;
        }

        public String text() {
            return !fails()
                    ? "holds"
                    : (shortest.isPresent()
                                    ? "fails after " + shortest.getAsInt() + " inputs"
                                    : "fails")
                            + (fitsFeedback ? "" : " (delay)");
        }
    }

    /**
     * @param leftAutomata those that count; of a composition none, for what its parts do
     * @param known letters of input and output whose messages are to be tried, too
     */
    public static Answer ask(
            Component left,
            List<Automaton> leftAutomata,
            Component right,
            List<Automaton> rightAutomata,
            List<Letter> known,
            int mostInputs) {
        boolean small = ports(left).stream().allMatch(p -> NaiveValues.isSmall(p.type()));
        if (!small && right.isComposite() && rightAutomata.isEmpty()) {
            return Answer.UNKNOWN;
        }
        List<Value> pool = small ? List.of() : pool(known);
        NaiveBehaviour mine = NaiveBehaviour.of(left, leftAutomata, pool, true);
        NaiveBehaviour theirs = NaiveBehaviour.of(right, rightAutomata, pool, false);
        List<Map<String, Value>> letters = letters(left, right, pool);
        if (letters.size() > MOST_LETTERS) {
            return Answer.UNKNOWN;
        }
        NaiveComparison comparison = new NaiveComparison(mine, theirs, letters, MOST_PAIRS);
        try {
            OptionalInt failure = comparison.shortestFailure(mostInputs);
            return new Answer(
                    failure, comparison.fitsFeedback(), small && comparison.isExhaustive(), false);
        } catch (NaiveComparison.TooMuch stopped) {
            return Answer.UNKNOWN;
        }
    }

    /** All ports, those of parts, too. */
    static List<Port> ports(Component component) {
        List<Port> ports = new ArrayList<>(component.ports());
        if (component.body() instanceof Component.Composite composite) {
            composite.parts().forEach(part -> ports.addAll(ports(part.component())));
        }
        return ports;
    }

    /** What large types are tried with: what is known, and some more of each. */
    private static List<Value> pool(List<Letter> known) {
        Set<Value> pool = new LinkedHashSet<>();
        known.forEach(letter -> letter.messages().values().forEach(pool::addAll));
        for (int i = -1; i <= 2; i++) {
            pool.add(new Value.IntegerValue(i));
        }
        List.of("", "a", "z").forEach(text -> pool.add(new Value.StringValue(text)));
        pool.add(new Value.IntegerValue(Integer.MAX_VALUE));
        "`abcz\u0000".chars().forEach(c -> pool.add(new Value.CharacterValue((char) c)));
        List.of(0.0, 0.5, 1.5, Double.NaN).forEach(number -> pool.add(new Value.RealValue(number)));
        return List.copyOf(pool);
    }

    /** Every letter of input; of a large type the messages of a pool. */
    static List<Map<String, Value>> letters(Component left, Component right, List<Value> pool) {
        boolean events = left.profile() == Component.Profile.EVENT_DRIVEN;
        List<Map<String, Value>> letters = List.of(Map.of());
        for (Port port : left.inputs()) {
            boolean total = port.total() || right.port(port.name()).map(Port::total).orElse(false);
            List<Value> messages = new ArrayList<>(NaiveValues.all(port.type(), pool));
            if (!total) {
                messages.add(null);
            }
            List<Map<String, Value>> longer = new ArrayList<>();
            for (Map<String, Value> letter : letters) {
                for (Value message : messages) {
                    Map<String, Value> copy = new HashMap<>(letter);
                    copy.put(port.name(), message);
                    longer.add(copy);
                }
            }
            letters = longer;
        }
        return events
                ? letters.stream().filter(letter -> events(left, letter) == 1).toList()
                : letters;
    }

    private static long events(Component component, Map<String, Value> letter) {
        return component.inputs().stream()
                .filter(p -> !p.latched() && letter.get(p.name()) != null)
                .count();
    }
}
