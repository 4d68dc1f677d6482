package arcomat.symbols.bodies;

import arcomat.source.Span;
import arcomat.symbols.bodies.InstanceSymbol.Origin;
import arcomat.symbols.names.Names;
import arcomat.symbols.names.Resolution;
import arcomat.symbols.names.TypeSymbol;
import arcomat.symbols.signatures.ComponentReference;
import arcomat.symbols.signatures.Signature;
import arcomat.tree.Argument;
import arcomat.tree.Component;
import arcomat.tree.Element;
import arcomat.tree.Name;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;

/** Finds the instances of a component: declared ones in text order, then automatic ones. */
final class Instances {
    private final List<InstanceSymbol> all;
    private final Map<String, InstanceSymbol> byName = new HashMap<>();

    private Instances(List<InstanceSymbol> all) {
        this.all = List.copyOf(all);
        all.forEach(instance -> byName.putIfAbsent(instance.name(), instance));
    }

    static Instances of(ComponentSymbol component) {
        List<ComponentSymbol> lineage = component.lineage();
        if (lineage.size() == 1) {
            return new Instances(component.ownInstances());
        }
        List<InstanceSymbol> all = new ArrayList<>();
        for (int i = lineage.size() - 1; i >= 0; i--) {
            all.addAll(lineage.get(i).ownInstances());
        }
        return new Instances(all);
    }

    List<InstanceSymbol> all() {
        return all;
    }

    Optional<InstanceSymbol> named(String name) {
        return Optional.ofNullable(byName.get(name));
    }

    /** What a component itself instantiates. */
    static List<InstanceSymbol> declaredIn(ComponentSymbol owner) {
        List<InstanceSymbol> instances = new ArrayList<>();
        // By identity: to hash a node is to walk all that is in it, at each level once more.
        Map<Component, ComponentSymbol> inner = new IdentityHashMap<>();
        owner.innerComponents().forEach(c -> inner.put(c.node(), c));
        for (Element element : owner.node().elements()) {
            if (element instanceof Element.Subcomponent subcomponent) {
                addDeclared(owner, subcomponent, instances);
            } else if (element instanceof Component component && component.instance().isPresent()) {
                instances.add(
                        named(
                                owner,
                                Objects.requireNonNull(inner.get(component)),
                                component.instance().get()));
            }
        }
        if (!inner.isEmpty() && instantiatesAutomatically(owner)) {
            addAutomatic(owner, instances);
        }
        return List.copyOf(instances);
    }

    private static void addDeclared(
            ComponentSymbol owner, Element.Subcomponent node, List<InstanceSymbol> instances) {
        ComponentReference type =
                ComponentReference.inside(owner.signature(), node.type(), node.arguments());
        List<Argument> arguments = forParameters(owner, node);
        List<Element.Instance> declared = node.instances();
        if (declared.isEmpty()) {
            Span span = node.type().span();
            Name name = new Name(span, Names.implicit(node.type().name().last().text()));
            instances.add(
                    new InstanceSymbol(
                            owner, name, Origin.IMPLICIT, node, type, arguments, List.of()));
        }
        for (Element.Instance instance : declared) {
            instances.add(
                    new InstanceSymbol(
                            owner,
                            instance.name(),
                            Origin.NAMED,
                            node,
                            type,
                            arguments,
                            instance.connectors()));
        }
    }

    private static List<Argument> forParameters(ComponentSymbol owner, Element.Subcomponent node) {
        Signature whole = owner.signature();
        return whole.forParameters(
                whole.resolveComponent(node.type().name()).found().map(Signature::declaration),
                node.arguments());
    }

    private static InstanceSymbol named(
            ComponentSymbol owner, ComponentSymbol inner, Component.NamedInstance instance) {
        return ofInner(
                owner,
                inner,
                instance.name(),
                Origin.NAMED,
                ComponentReference.resolve(owner.signature(), instance.arguments()));
    }

    private static InstanceSymbol ofInner(
            ComponentSymbol owner,
            ComponentSymbol inner,
            Name name,
            Origin origin,
            List<Resolution<TypeSymbol>> arguments) {
        ComponentReference type =
                new ComponentReference(
                        inner.nameSpan(),
                        inner.name(),
                        new Resolution.Found<>(inner.signature()),
                        arguments);
        return new InstanceSymbol(owner, name, origin, inner.node(), type, List.of(), List.of());
    }

    /** On unless the last word about it is {@code off}. */
    private static boolean instantiatesAutomatically(ComponentSymbol owner) {
        List<Element.Autoinstantiate> words = owner.node().elements(Element.Autoinstantiate.class);
        return words.isEmpty() || words.get(words.size() - 1).on();
    }

    private static void addAutomatic(ComponentSymbol owner, List<InstanceSymbol> instances) {
        Set<String> used = new HashSet<>();
        collectTypeNames(owner.node(), used);
        for (ComponentSymbol inner : owner.innerComponents()) {
            boolean ready =
                    inner.node().instance().isEmpty() && inner.signature().needsNoArguments();
            if (ready && !used.contains(inner.name())) {
                Name name = new Name(inner.nameSpan(), Names.implicit(inner.name()));
                instances.add(ofInner(owner, inner, name, Origin.AUTOMATIC, List.of()));
            }
        }
    }

    /** The simple names of everything that is instantiated in a component or in its inner ones. */
    private static void collectTypeNames(Component component, Set<String> names) {
        for (Element element : component.elements()) {
            if (element instanceof Element.Subcomponent subcomponent) {
                names.add(subcomponent.type().name().last().text());
            } else if (element instanceof Component inner) {
                collectTypeNames(inner, names);
            }
        }
    }
}
