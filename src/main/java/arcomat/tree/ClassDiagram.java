package arcomat.tree;

import arcomat.source.Span;

import java.util.List;
import java.util.Optional;

/** A UML/P class diagram that defines message types. */
public record ClassDiagram(
        Span span,
        List<Stereotype> stereotypes,
        Name name,
        List<TypeDefinition> types,
        List<Association> associations)
        implements Definition {
    @Override
    public <R> R match(Cases<R> cases) {
        return cases.diagram().apply(this);
    }

    /** What a diagram holds, between its braces. */
    public sealed interface Entry extends Node permits TypeDefinition, Association {
        List<Stereotype> stereotypes();

        /** Words and signs in front, as {@code public} and {@code +}. */
        List<Name> modifiers();
    }

    public sealed interface TypeDefinition extends Entry {
        Name name();

        /** The interfaces that it implements or, as one, extends. */
        default List<TypeReference> interfaces() {
            return List.of();
        }

        /** Empty for types without a body, too. */
        default List<Member> members() {
            return List.of();
        }
    }

    /**
     * @param arguments of constants that have some
     */
    public record EnumDefinition(
            Span span,
            List<Stereotype> stereotypes,
            List<Name> modifiers,
            Name name,
            List<TypeReference> interfaces,
            List<Name> constants,
            List<ConstantArguments> arguments,
            List<Member> members)
            implements TypeDefinition {}

    /**
     * @param span without the constant
     */
    public record ConstantArguments(Span span, Name constant, List<Expression> arguments)
            implements Node {}

    public record ClassDefinition(
            Span span,
            List<Stereotype> stereotypes,
            List<Name> modifiers,
            Name name,
            Optional<TypeReference> superClass,
            List<TypeReference> interfaces,
            List<Member> members)
            implements TypeDefinition {
        public List<Attribute> attributes() {
            return Node.ofKind(Attribute.class, members);
        }
    }

    /** A type of which nothing is known but its name. */
    public sealed interface NamedType extends TypeDefinition {}

    public record InterfaceDefinition(
            Span span,
            List<Stereotype> stereotypes,
            List<Name> modifiers,
            Name name,
            List<TypeReference> interfaces,
            List<Member> members)
            implements NamedType {}

    /** {@code type Name;}. */
    public record OpaqueDefinition(Span span, List<Stereotype> stereotypes, Name name)
            implements NamedType {
        @Override
        public List<Name> modifiers() {
            return List.of();
        }
    }

    public sealed interface Member extends Node {
        List<Name> modifiers();

        Name name();
    }

    public record Attribute(
            Span span,
            List<Stereotype> stereotypes,
            List<Name> modifiers,
            TypeReference type,
            Name name,
            Optional<Expression> value)
            implements Member {}

    /**
     * The signature of a method.
     *
     * @param result empty for a constructor
     * @param body the text of its block, if it has one
     */
    public record Method(
            Span span,
            List<Stereotype> stereotypes,
            List<Name> modifiers,
            Optional<TypeReference> result,
            Name name,
            List<MethodParameter> parameters,
            List<TypeReference> thrown,
            Optional<String> body)
            implements Member {}

    public record MethodParameter(Span span, TypeReference type, Name name) implements Node {}

    /**
     * @param kind its first word, {@code association}
     * @param arrow as written, without spaces
     */
    public record Association(
            Span span,
            List<Stereotype> stereotypes,
            List<Name> modifiers,
            String kind,
            Optional<Name> name,
            AssociationEnd left,
            String arrow,
            AssociationEnd right)
            implements Entry {}

    /**
     * @param cardinality as written, without spaces
     * @param qualifier as written, without spaces
     */
    public record AssociationEnd(
            Span span,
            TypeReference type,
            Optional<String> cardinality,
            Optional<String> qualifier,
            Optional<Name> role)
            implements Node {}
}
