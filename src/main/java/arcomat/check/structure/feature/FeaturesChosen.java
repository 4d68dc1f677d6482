package arcomat.check.structure.feature;

import arcomat.check.facts.Wording;
import arcomat.check.law.Check;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.InstanceSymbol;
import arcomat.symbols.bodies.TestSuiteSymbol;
import arcomat.symbols.names.ComponentDeclaration;
import arcomat.symbols.names.FeatureChoice;
import arcomat.symbols.names.Variants;
import arcomat.symbols.signatures.Signature;
import arcomat.tree.Argument;
import arcomat.tree.Component;
import arcomat.tree.Element;
import arcomat.tree.Expression;
import arcomat.tree.Name;
import arcomat.tree.Node;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * ARC0152: whoever uses a component with features chooses each of them once, so that its
 * constraints hold.
 */
public final class FeaturesChosen
        implements Check.OnComponent, Check.OnInstance, Check.OnTestSuite {

    /** Somewhere that a component is named, with arguments. */
    private record Use(Node place, List<Argument> arguments, FeatureChoice around) {}

    @Override
    public void check(ComponentSymbol component, Context context, Findings findings) {
        Signature heir = component.signature();
        heir.superNamed()
                .ifPresent(
                        above ->
                                check(
                                        new Use(
                                                heir.node().superComponent().orElseThrow(),
                                                heir.node().superArguments().orElse(List.of()),
                                                heir.declaration().configuration()),
                                        above,
                                        findings));
        for (Component.Refined refined : heir.node().refined()) {
            heir.resolveComponent(refined.name())
                    .found()
                    .ifPresent(named -> refines(refined, heir, named.declaration(), findings));
        }
    }

    /** Arguments that are no choices would mean nothing there. */
    private static void refines(
            Component.Refined refined,
            Signature heir,
            ComponentDeclaration named,
            Findings findings) {
        List<String> features = named.variants().map(Variants::names).orElse(List.of());
        Optional<Argument> other =
                refined.arguments().stream()
                        .filter(
                                each ->
                                        each.name()
                                                .filter(name -> features.contains(name.text()))
                                                .isEmpty())
                        .findFirst();
        if (other.isPresent()) {
            findings.report(
                    other.get(),
                    "behind 'refines' arguments choose features, and this chooses none of '%s';"
                            + " delete it",
                    named.name());
        } else {
            FeatureChoice around = heir.declaration().configuration();
            check(new Use(refined.name(), refined.arguments(), around), named, findings);
        }
    }

    @Override
    public void check(InstanceSymbol instance, Context context, Findings findings) {
        if (instance.node() instanceof Element.Subcomponent node) {
            Signature whole = instance.owner().signature();
            Use use = new Use(node.type(), node.arguments(), whole.declaration().configuration());
            whole.resolveComponent(node.type().name())
                    .found()
                    .ifPresent(type -> check(use, type.declaration(), findings));
        }
    }

    @Override
    public void check(TestSuiteSymbol suite, Context context, Findings findings) {
        Use use = new Use(suite.node().component(), suite.node().arguments(), FeatureChoice.NONE);
        suite.component().found().ifPresent(type -> check(use, type.declaration(), findings));
    }

    private static void check(Use use, ComponentDeclaration named, Findings findings) {
        ComponentDeclaration meant = named.chosen(use.arguments(), use.around());
        if (!meant.isOpen()) {
            once(use.arguments(), meant.configuration(), findings);
        } else if (meant.variants().isEmpty()) {
            findings.report(
                    use.place(),
                    "'%s' lies in a component with features and is another one in each of its"
                            + " configurations; define it in a file of its own",
                    meant.name());
        } else if (!meant.configurations().isEmpty()) {
            open(use, meant.variants().get(), findings);
        }
    }

    private static void once(
            List<Argument> arguments, FeatureChoice configuration, Findings findings) {
        Map<String, Argument> seen = new HashMap<>();
        for (Argument argument : arguments) {
            Optional<Name> feature =
                    argument.name()
                            .filter(name -> configuration.choices().containsKey(name.text()));
            feature.map(name -> seen.putIfAbsent(name.text(), argument))
                    .ifPresent(
                            first ->
                                    findings.report(
                                                    argument,
                                                    "feature '%s' is chosen already; delete one",
                                                    feature.get())
                                            .related(first, "the other argument"));
        }
    }

    /** The first reason why no configuration is chosen. */
    private static void open(Use use, Variants variants, Findings findings) {
        List<String> left =
                variants.names().stream()
                        .filter(name -> FeatureChoice.given(name, use.arguments()).isEmpty())
                        .toList();
        Optional<Expression> unclear =
                variants.names().stream()
                        .flatMap(name -> FeatureChoice.given(name, use.arguments()).stream())
                        .filter(value -> use.around().holds(value).isEmpty())
                        .findFirst();
        if (!left.isEmpty()) {
            findings.report(
                    use.place(),
                    "choose %s of '%s': write %s in parentheses behind it",
                    Wording.quoted(left),
                    variants.node().name(),
                    String.join(" = true, ", left) + " = true, or false");
        } else if (unclear.isPresent()) {
            findings.report(
                    unclear.get(),
                    "a feature is chosen by true, by false, or by features of the component around"
                            + " it");
        } else {
            forbidden(use, variants, findings);
        }
    }

    private static void forbidden(Use use, Variants variants, Findings findings) {
        FeatureChoice chosen =
                FeatureChoice.chosen(variants.names(), use.arguments(), use.around());
        variants.constraints().stream()
                .filter(each -> !chosen.holds(each).orElse(true))
                .findFirst()
                .ifPresent(
                        broken ->
                                findings.report(
                                                use.place(),
                                                "%s breaks a constraint of '%s'; choose others",
                                                chosen.text(),
                                                variants.node().name())
                                        .related(broken, "the constraint"));
    }
}
