package arcomat.symbols.bodies;

import arcomat.source.Span;
import arcomat.symbols.expressions.ExpressionTyping;
import arcomat.symbols.expressions.GivenArgument;
import arcomat.symbols.expressions.PortSymbol;
import arcomat.symbols.names.JavaType;
import arcomat.symbols.names.Lazy;
import arcomat.symbols.names.TypeSubstitution;
import arcomat.symbols.names.TypeVariable;
import arcomat.symbols.signatures.ComponentReference;
import arcomat.tree.Argument;
import arcomat.tree.Element;
import arcomat.tree.Name;
import arcomat.tree.Node;

import java.util.List;
import java.util.Optional;

/** An instance of a component inside another. */
public final class InstanceSymbol {
    /** Where an instance comes from. */
    public enum Origin {
        /**
         * Declared with a name, {@code component Type name;} or {@code component Type name {..}}.
         */
        NAMED,
        /** Declared without a name, so named after its type. */
        IMPLICIT,
        /** Made for an inner component that nothing instantiates. */
        AUTOMATIC
    }

    private final ComponentSymbol owner;
    private final Name name;
    private final Origin origin;
    private final Node node;
    private final ComponentReference type;
    private final List<Argument> arguments;
    private final List<Element.SimpleConnector> simpleConnectors;
    private final Lazy<List<GivenArgument>> typedArguments = new Lazy<>(this::typeArguments);

    InstanceSymbol(
            ComponentSymbol owner,
            Name name,
            Origin origin,
            Node node,
            ComponentReference type,
            List<Argument> arguments,
            List<Element.SimpleConnector> simpleConnectors) {
        this.owner = owner;
        this.name = name;
        this.origin = origin;
        this.node = node;
        this.type = type;
        this.arguments = arguments;
        this.simpleConnectors = simpleConnectors;
    }

    /** The component it was declared in; an heir has it too. */
    public ComponentSymbol owner() {
        return owner;
    }

    public String name() {
        return name.text();
    }

    /** Where its name is; its type, where the name is implicit or automatic. */
    public Span nameSpan() {
        return name.span();
    }

    public Origin origin() {
        return origin;
    }

    /** The {@code Element.Subcomponent} or the inner {@code Component} that declares it. */
    public Node node() {
        return node;
    }

    public ComponentReference type() {
        return type;
    }

    public Optional<ComponentSymbol> component() {
        return type.component().map(owner::of);
    }

    List<Element.SimpleConnector> simpleConnectors() {
        return simpleConnectors;
    }

    /** The arguments as written, typed against the parameters they meet. */
    public List<GivenArgument> arguments() {
        return typedArguments.get();
    }

    private List<GivenArgument> typeArguments() {
        return GivenArgument.of(
                arguments,
                component().map(ComponentSymbol::parameters).orElse(List.of()),
                type.substitution()::apply,
                ExpressionTyping.at(owner.constantScope()));
    }

    /** Its ports as seen from outside: type arguments are in place. */
    public List<PortSymbol> ports() {
        List<PortSymbol> inside = component().map(ComponentSymbol::ports).orElse(List.of());
        TypeSubstitution substitution = type.substitution();
        return substitution.arguments().isEmpty()
                ? inside
                : inside.stream().map(port -> port.with(substitution)).toList();
    }

    public Optional<PortSymbol> port(String portName) {
        return component().flatMap(c -> c.port(portName)).map(this::seenFromOutside);
    }

    private PortSymbol seenFromOutside(PortSymbol port) {
        return port.type() instanceof TypeVariable || port.type() instanceof JavaType
                ? port.with(type.substitution())
                : port;
    }

    @Override
    public String toString() {
        return name();
    }
}
