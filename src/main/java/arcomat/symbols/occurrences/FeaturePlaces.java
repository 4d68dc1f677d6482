package arcomat.symbols.occurrences;

import arcomat.symbols.names.ComponentDeclaration;
import arcomat.symbols.names.Variants;
import arcomat.symbols.occurrences.Occurrence.Role;
import arcomat.symbols.signatures.Signature;
import arcomat.tree.Argument;
import arcomat.tree.Component;
import arcomat.tree.Element;
import arcomat.tree.Expression;
import arcomat.tree.Name;
import arcomat.tree.Node;

import java.util.List;
import java.util.Optional;

/**
 * Names of features: where they are declared, where conditions ask for them, and where arguments
 * choose them.
 *
 * @param around the component whose features conditions speak of
 */
record FeaturePlaces(NamePlaces places, Optional<Component> around) {

    /** In the component that a file is about, or one inside it. */
    static FeaturePlaces in(Signature component, NamePlaces places) {
        Signature outermost = component;
        while (outermost.enclosing().isPresent()) {
            outermost = outermost.enclosing().get();
        }
        return new FeaturePlaces(places, Optional.of(outermost.node()));
    }

    /** Declarations and conditions, those of all sides. */
    void declaredBy(ComponentDeclaration component) {
        component.node().elements(Element.Features.class).stream()
                .flatMap(each -> each.names().stream())
                .forEach(name -> feature(name, around, name.text(), Role.DECLARES));
        elements(component.variants().map(Variants::node).orElse(component.node()).elements());
    }

    private void elements(List<Element> elements) {
        Node.ofKind(Element.Constraint.class, elements)
                .forEach(each -> condition(each.condition()));
        Node.ofKind(Component.class, elements).forEach(inner -> elements(inner.elements()));
        for (Element.Variation variation : Node.ofKind(Element.Variation.class, elements)) {
            condition(variation.condition());
            elements(variation.then());
            elements(variation.otherwise());
        }
    }

    private void condition(Expression condition) {
        if (condition instanceof Expression.Reference reference && reference.name().isSimple()) {
            Name name = reference.name().last();
            feature(name, around, name.text(), Role.READS);
        }
        condition.operands().forEach(this::condition);
    }

    /** Those that choose features of the component that is named. */
    void arguments(List<Argument> given, Optional<ComponentDeclaration> named) {
        Optional<Component> chosen = named.map(ComponentDeclaration::node);
        for (Argument each : given) {
            Optional<Name> name = each.name().filter(word -> isFeature(word, chosen));
            if (name.isPresent()) {
                feature(name.get(), chosen, name.get().text(), Role.REFERS);
                condition(each.value());
            }
        }
    }

    private static boolean isFeature(Name name, Optional<Component> component) {
        return component.flatMap(each -> declared(each, name.text())).isPresent();
    }

    private void feature(Name place, Optional<Component> component, String name, Role role) {
        component.ifPresent(
                each ->
                        declared(each, name)
                                .ifPresent(
                                        found ->
                                                places.add(
                                                        place.span(),
                                                        new Referent.Feature(
                                                                found, each.name().text()),
                                                        role)));
    }

    /** Of one name the first. */
    private static Optional<Name> declared(Component component, String name) {
        return component.elements(Element.Features.class).stream()
                .flatMap(each -> each.names().stream())
                .filter(each -> each.text().equals(name))
                .findFirst();
    }
}
