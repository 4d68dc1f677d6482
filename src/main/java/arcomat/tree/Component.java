package arcomat.tree;

import arcomat.source.Span;
import arcomat.tree.TypeReference.TypeArgument;

import java.util.List;
import java.util.Optional;

/**
 * A component type, top-level or inner.
 *
 * @param superArguments for the parameters of the component it extends; empty where none are
 *     written, so that it has those parameters itself
 * @param instance the instance declared with it, {@code component A a {..}}
 */
public record Component(
        Span span,
        List<Stereotype> stereotypes,
        boolean isAbstract,
        boolean isDeploy,
        Name name,
        List<TypeParameter> typeParameters,
        List<Parameter> parameters,
        Optional<TypeReference> superComponent,
        Optional<List<Argument>> superArguments,
        List<Refined> refined,
        Optional<NamedInstance> instance,
        List<Element> elements)
        implements Definition, Element {
    /** {@code a<Integer>} behind the name of a component. */
    public record NamedInstance(Span span, Name name, List<TypeArgument> arguments)
            implements Node {}

    /**
     * A component that is refined.
     *
     * @param arguments which of its features are chosen
     */
    public record Refined(Span span, QualifiedName name, List<Argument> arguments)
            implements Node {}

    /** The names of what it refines. */
    public List<QualifiedName> refines() {
        return refined.stream().map(Refined::name).toList();
    }

    /** The elements of one kind, in text order. */
    public <E extends Element> List<E> elements(Class<E> kind) {
        return Node.ofKind(kind, elements);
    }

    /** The same component with other things in its body. */
    public Component withElements(List<Element> others) {
        return new Component(
                span,
                stereotypes,
                isAbstract,
                isDeploy,
                name,
                typeParameters,
                parameters,
                superComponent,
                superArguments,
                refined,
                instance,
                others);
    }

    @Override
    public <R> R match(Cases<R> cases) {
        return cases.component().apply(this);
    }

    @Override
    public void accept(Visitor visitor) {
        visitor.component(this);
    }

    /** A configuration parameter of a component. */
    public record Parameter(Span span, TypeReference type, Name name, Optional<Expression> initial)
            implements Node {}

    /** {@code T} or {@code T extends Bound & Bound}. */
    public record TypeParameter(Span span, Name name, List<TypeReference> bounds) implements Node {}
}
