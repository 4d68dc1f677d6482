package arcomat.check.structure.feature;

import arcomat.check.law.Check;
import arcomat.symbols.names.FeatureChoice;
import arcomat.symbols.names.Variants;
import arcomat.tree.Behaviour;
import arcomat.tree.Component;
import arcomat.tree.Element;
import arcomat.tree.Expression;
import arcomat.tree.Name;
import arcomat.tree.Unit;

import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * ARC0150: the component that a file is about declares its features, each once, and not too many;
 * conditions speak of these and of nothing else.
 */
public final class FeaturesWellFormed implements Check.OnUnit {

    @Override
    public void check(Unit unit, Context context, Findings findings) {
        if (unit.definition() instanceof Component component) {
            Variants.orConstraintsOf(component).ifPresent(variants -> check(variants, findings));
        }
    }

    private static void check(Variants variants, Findings findings) {
        Component component = variants.node();
        namesUnique(component, findings);
        Map<String, Boolean> choices = new LinkedHashMap<>();
        variants.names().forEach(name -> choices.put(name, true));
        body(component.elements(), new FeatureChoice(choices), 0, findings);
        if (isTooMany(variants)) {
            findings.report(
                    variants.features().get(variants.features().size() - 1),
                    "'%s' has more than %s configurations, and each is looked at by itself; delete"
                            + " features, or say by constraints which go together",
                    component.name(),
                    Variants.MOST);
        }
    }

    private static boolean isTooMany(Variants variants) {
        return variants.features().size() > Variants.MOST_FEATURES
                || variants.configurations().size() > Variants.MOST;
    }

    private static void namesUnique(Component component, Findings findings) {
        Map<String, Name> seen = new HashMap<>();
        component.parameters().forEach(each -> seen.put(each.name().text(), each.name()));
        for (Element.Features declaration : component.elements(Element.Features.class)) {
            for (Name name : declaration.names()) {
                Optional.ofNullable(seen.putIfAbsent(name.text(), name))
                        .ifPresent(
                                first ->
                                        findings.report(
                                                        name,
                                                        "arguments could not tell the two '%s'"
                                                                + " apart; rename one",
                                                        name)
                                                .related(first, "the other one"));
            }
        }
    }

    /**
     * @param depth how many components and conditions are around the elements
     */
    private static void body(
            List<Element> elements, FeatureChoice features, int depth, Findings findings) {
        startBesideComputation(elements, depth, findings);
        for (Element each : elements) {
            if (each instanceof Element.Variation variation) {
                condition(variation.condition(), features, findings);
                body(variation.then(), features, depth + 1, findings);
                body(variation.otherwise(), features, depth + 1, findings);
            } else if (each instanceof Component inner) {
                body(inner.elements(), features, depth + 1, findings);
            } else {
                declaration(each, features, depth, findings);
            }
        }
    }

    /** What begins a computation is put together with it before anybody chooses features. */
    private static void startBesideComputation(
            List<Element> elements, int depth, Findings findings) {
        boolean varied =
                depth > 0 || elements.stream().anyMatch(Element.Variation.class::isInstance);
        if (varied && elements.stream().noneMatch(Behaviour.Computation.class::isInstance)) {
            elements.stream()
                    .filter(Element.Start.class::isInstance)
                    .forEach(
                            start ->
                                    findings.report(
                                            start,
                                            "'init' belongs to no 'compute' here; write it between"
                                                    + " the same braces as the 'compute' that it"
                                                    + " begins"));
        }
    }

    private static void declaration(
            Element element, FeatureChoice features, int depth, Findings findings) {
        boolean aboutFeatures =
                element instanceof Element.Features || element instanceof Element.Constraint;
        if (aboutFeatures && depth > 0) {
            findings.report(
                    element,
                    "features and their constraints belong to the component that the file is"
                            + " about; write this there, beside its ports");
        } else if (element instanceof Element.Constraint constraint
                && !isDecided(constraint, features)) {
            condition(constraint.condition(), features, findings);
        }
    }

    /** Without features a constraint is true and of no use, or false (ARC0151). */
    private static boolean isDecided(Element.Constraint constraint, FeatureChoice features) {
        return features.choices().isEmpty() && features.holds(constraint.condition()).isPresent();
    }

    private static void condition(Expression condition, FeatureChoice features, Findings findings) {
        if (features.holds(condition).isEmpty()) {
            findings.report(
                    condition,
                    "this condition is to be about features of the component and nothing else: %s",
                    features.choices().isEmpty()
                            ? "declare them, 'feature f;'"
                            : "'" + String.join("', '", features.choices().keySet()) + "'");
        } else if (features.choices().isEmpty()) {
            findings.report(condition, "there is no feature to choose; declare one, 'feature f;'");
        }
    }
}
