package arcomat.tree;

import arcomat.source.Span;

import java.util.List;
import java.util.Optional;

/** A UML/P class diagram that defines message types. */
public record ClassDiagram(Span span, Name name, List<TypeDefinition> types) implements Definition {
    public ClassDiagram {
        types = List.copyOf(types);
    }

    public sealed interface TypeDefinition extends Node {
        Name name();
    }

    public record EnumDefinition(Span span, Name name, List<Name> constants)
            implements TypeDefinition {
        public EnumDefinition {
            constants = List.copyOf(constants);
        }
    }

    public record ClassDefinition(
            Span span, Name name, Optional<TypeReference> superClass, List<Attribute> attributes)
            implements TypeDefinition {
        public ClassDefinition {
            attributes = List.copyOf(attributes);
        }
    }

    public record Attribute(Span span, TypeReference type, Name name) implements Node {}
}
