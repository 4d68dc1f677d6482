package arcomat.symbols.names;

import arcomat.tree.Component;
import arcomat.tree.Element;
import arcomat.tree.Expression;
import arcomat.tree.Name;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.stream.Stream;

/**
 * A component of which there are several kinds: its features, what is said of them, and the text of
 * each kind.
 *
 * @param node as it is written
 * @param features those that are declared, of one name the first
 * @param constraints true in each configuration
 */
public record Variants(Component node, List<Name> features, List<Expression> constraints) {
    /**
     * Configurations of one component; each is looked at by itself wherever all are asked about.
     */
    public static final int MOST = 64;

    /** Features of one component: as many choices as can be tried one by one. */
    public static final int MOST_FEATURES = 16;

    public Variants {
        features = List.copyOf(features);
        constraints = List.copyOf(constraints);
    }

    /** Empty for a component that says nothing of features. */
    public static Optional<Variants> of(Component node) {
        return isVaried(node) ? Optional.of(written(node)) : Optional.empty();
    }

    /**
     * The same, also for a component that has constraints and nothing to choose: it has one
     * configuration, or none where a constraint is false.
     */
    public static Optional<Variants> orConstraintsOf(Component node) {
        return isVaried(node) || isConstrained(node)
                ? Optional.of(written(node))
                : Optional.empty();
    }

    private static boolean isConstrained(Component node) {
        return !node.elements(Element.Constraint.class).isEmpty()
                || node.elements(Component.class).stream().anyMatch(Variants::isConstrained);
    }

    private static Variants written(Component node) {
        return new Variants(
                node,
                firsts(node),
                node.elements(Element.Constraint.class).stream()
                        .map(Element.Constraint::condition)
                        .toList());
    }

    private static boolean isVaried(Component node) {
        return !node.elements(Element.Features.class).isEmpty()
                || !node.elements(Element.Variation.class).isEmpty()
                || node.elements(Component.class).stream().anyMatch(Variants::isVaried);
    }

    private static List<Name> firsts(Component node) {
        Map<String, Name> byName = new LinkedHashMap<>();
        node.elements(Element.Features.class).stream()
                .flatMap(each -> each.names().stream())
                .forEach(name -> byName.putIfAbsent(name.text(), name));
        return List.copyOf(byName.values());
    }

    public List<String> names() {
        return features.stream().map(Name::text).toList();
    }

    /**
     * The configurations that the constraints allow; one more than {@link #MOST} where there are
     * more, and none of more features than {@link #MOST_FEATURES}. A constraint without a truth
     * forbids none.
     */
    public List<FeatureChoice> configurations() {
        return features.size() > MOST_FEATURES
                ? List.of()
                : all().filter(this::isAllowed).limit(MOST + 1L).toList();
    }

    /** All choices, true before false, the first feature slowest. */
    private Stream<FeatureChoice> all() {
        int count = 1 << features.size();
        return Stream.iterate(count - 1, number -> number >= 0, number -> number - 1)
                .map(this::numbered);
    }

    private FeatureChoice numbered(int number) {
        Map<String, Boolean> choices = new LinkedHashMap<>();
        for (int i = 0; i < features.size(); i++) {
            boolean chosen = (number >> (features.size() - 1 - i) & 1) == 1;
            choices.put(features.get(i).text(), chosen);
        }
        return new FeatureChoice(choices);
    }

    /** Whether no constraint forbids a configuration. */
    public boolean isAllowed(FeatureChoice configuration) {
        return constraints.stream().allMatch(each -> configuration.holds(each).orElse(true));
    }

    /** What one configuration has. */
    public Component node(FeatureChoice configuration) {
        return with(node, each -> configuration.holds(each.condition()).orElse(true), false);
    }

    /** With all that any configuration has: for who looks for a name and does not ask whose. */
    public Component everything() {
        return with(node, each -> true, true);
    }

    private static Component with(
            Component node, Predicate<Element.Variation> taken, boolean both) {
        List<Element> elements = new ArrayList<>();
        add(node.elements(), taken, both, elements);
        return node.withElements(elements);
    }

    private static void add(
            List<Element> written,
            Predicate<Element.Variation> taken,
            boolean both,
            List<Element> elements) {
        for (Element each : written) {
            if (each instanceof Element.Variation variation) {
                boolean then = taken.test(variation);
                add(then ? variation.then() : List.of(), taken, both, elements);
                add(both || !then ? variation.otherwise() : List.of(), taken, both, elements);
            } else {
                elements.add(each instanceof Component inner ? with(inner, taken, both) : each);
            }
        }
    }
}
