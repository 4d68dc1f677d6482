package arcomat.symbols.names;

import arcomat.source.Span;
import arcomat.tree.Component;
import arcomat.tree.Unit;

import java.util.List;
import java.util.Optional;

/**
 * A component as its file defines it, top-level or inner: where it stands and what it is called.
 */
public final class ComponentDeclaration {
    private final UnitScope scope;
    private final Component node;
    private final Optional<ComponentDeclaration> enclosing;
    private final String qualifiedName;
    private final List<ComponentDeclaration> inner;
    private final List<TypeVariable> typeParameters;

    private ComponentDeclaration(
            UnitScope scope, Component node, Optional<ComponentDeclaration> enclosing) {
        this.scope = scope;
        this.node = node;
        this.enclosing = enclosing;
        this.qualifiedName =
                Names.join(
                        enclosing.map(e -> e.qualifiedName).orElse(scope.unit().packageText()),
                        node.name().text());
        this.inner =
                node.elements(Component.class).stream()
                        .map(c -> new ComponentDeclaration(scope, c, Optional.of(this)))
                        .toList();
        this.typeParameters = node.typeParameters().stream().map(TypeVariable::new).toList();
    }

    public static ComponentDeclaration topLevel(UnitScope scope, Component node) {
        return new ComponentDeclaration(scope, node, Optional.empty());
    }

    public Component node() {
        return node;
    }

    public Unit unit() {
        return scope.unit();
    }

    /** What names in its file reach. */
    public UnitScope unitScope() {
        return scope;
    }

    public String name() {
        return node.name().text();
    }

    public Span nameSpan() {
        return node.name().span();
    }

    /** {@code package.Outer.Inner}. */
    public String qualifiedName() {
        return qualifiedName;
    }

    public Optional<ComponentDeclaration> enclosing() {
        return enclosing;
    }

    public List<ComponentDeclaration> innerComponents() {
        return inner;
    }

    public List<TypeVariable> typeParameters() {
        return typeParameters;
    }

    @Override
    public String toString() {
        return qualifiedName;
    }
}
