package arcomat.tree;

import arcomat.source.Span;

import java.util.List;
import java.util.Optional;

/** A UML/P class diagram that defines message types. */
public record ClassDiagram(Span span, Name name, List<TypeDefinition> types) implements Definition {
    @Override
    public <R> R match(Cases<R> cases) {
        return cases.diagram().apply(this);
    }

    public sealed interface TypeDefinition extends Node {
        Name name();
    }

    public record EnumDefinition(Span span, Name name, List<Name> constants)
            implements TypeDefinition {}

    public record ClassDefinition(
            Span span, Name name, Optional<TypeReference> superClass, List<Attribute> attributes)
            implements TypeDefinition {}

    public record Attribute(Span span, TypeReference type, Name name) implements Node {}
}
