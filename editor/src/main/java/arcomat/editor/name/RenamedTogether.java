package arcomat.editor.name;

import arcomat.source.ArrayNames;
import arcomat.symbols.Workspace;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.InstanceSymbol;
import arcomat.symbols.expressions.ParameterSymbol;
import arcomat.symbols.expressions.PortSymbol;
import arcomat.symbols.names.Names;
import arcomat.symbols.names.Resolution;
import arcomat.symbols.occurrences.Referent;
import arcomat.symbols.signatures.Signature;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Stream;

/**
 * What has to change its name with something, so that models mean what they meant: ports that a
 * refining component has to have, ports and parameters that an heir declares again, and what has
 * its name from its type.
 */
final class RenamedTogether {
    private final Workspace workspace;
    private final Map<Referent, String> names = new LinkedHashMap<>();
    private final Deque<Referent> open = new ArrayDeque<>();

    private RenamedTogether(Workspace workspace) {
        this.workspace = workspace;
    }

    /** Returns the new name of each, the first one's included. */
    static Map<Referent, String> of(Workspace workspace, Referent first, String name) {
        RenamedTogether group = new RenamedTogether(workspace);
        group.add(first, name);
        while (!group.open.isEmpty()) {
            group.addNeighbours(group.open.remove());
        }
        return group.names;
    }

    private void add(Referent referent, String name) {
        if (names.putIfAbsent(referent, name) == null) {
            open.add(referent);
        }
    }

    private String newName(Referent referent) {
        return names.getOrDefault(referent, referent.name());
    }

    private void addNeighbours(Referent referent) {
        if (referent.one() instanceof Referent.Port port) {
            addPorts(port.symbol().name(), referent);
        } else if (referent instanceof Referent.Parameter parameter) {
            addParameters(parameter);
        } else {
            addImplicit(referent);
        }
    }

    private Stream<Signature> signatures() {
        return workspace.components().stream().map(ComponentSymbol::signature);
    }

    /** Arrays that are compared have their first elements. */
    private void addPorts(String declared, Referent renamed) {
        String name =
                ArrayNames.isElement(declared)
                        ? ArrayNames.element(ArrayNames.array(declared), 0)
                        : declared;
        signatures()
                .forEach(
                        component -> {
                            component.refines().stream()
                                    .map(Signature.Refinement::resolution)
                                    .map(Resolution::found)
                                    .flatMap(Optional::stream)
                                    .forEach(
                                            refined ->
                                                    addIfOne(
                                                            ports(
                                                                    component.port(name),
                                                                    refined.port(name)),
                                                            renamed));
                            addIfOne(declaredAlong(component, name), renamed);
                        });
    }

    private static List<Referent> ports(Optional<PortSymbol> one, Optional<PortSymbol> other) {
        return Stream.of(one, other).flatMap(Optional::stream).map(RenamedTogether::named).toList();
    }

    /** In a component and those above, if the component itself declares one of them. */
    private static List<Referent> declaredAlong(Signature component, String name) {
        return along(component, name, Signature::ownPorts, PortSymbol::name).stream()
                .map(RenamedTogether::named)
                .toList();
    }

    private static Referent named(PortSymbol port) {
        return Referent.Array.around(new Referent.Port(port));
    }

    private static <T> List<T> along(
            Signature component,
            String name,
            Function<Signature, List<T>> own,
            Function<T, String> names) {
        boolean declares =
                own.apply(component).stream().anyMatch(each -> names.apply(each).equals(name));
        return declares
                ? component.lineage().stream()
                        .flatMap(each -> own.apply(each).stream())
                        .filter(each -> names.apply(each).equals(name))
                        .toList()
                : List.of();
    }

    private void addIfOne(List<Referent> together, Referent renamed) {
        if (together.contains(renamed)) {
            together.forEach(each -> add(each, newName(renamed)));
        }
    }

    private void addParameters(Referent.Parameter renamed) {
        signatures()
                .forEach(
                        component ->
                                addIfOne(
                                        along(
                                                        component,
                                                        renamed.name(),
                                                        Signature::ownParameters,
                                                        ParameterSymbol::name)
                                                .stream()
                                                .<Referent>map(Referent.Parameter::new)
                                                .toList(),
                                        renamed));
    }

    /** Ports of a type and parts of a component that have no name of their own. */
    private void addImplicit(Referent type) {
        String name = Names.implicit(newName(type));
        for (ComponentSymbol component : workspace.components()) {
            component.signature().ownPorts().stream()
                    .filter(PortSymbol::implicit)
                    .map(Referent.Port::new)
                    .filter(port -> port.typeReferent().filter(type::equals).isPresent())
                    .forEach(port -> add(port, name));
            component.ownInstances().stream()
                    .filter(part -> part.origin() != InstanceSymbol.Origin.NAMED)
                    .map(Referent.Part::new)
                    .filter(part -> part.typeReferent().filter(type::equals).isPresent())
                    .forEach(part -> add(part, name));
        }
    }
}
