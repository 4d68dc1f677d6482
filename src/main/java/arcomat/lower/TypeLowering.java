package arcomat.lower;

import arcomat.model.Type;
import arcomat.symbols.names.BuiltinType;
import arcomat.symbols.names.ClassSymbol;
import arcomat.symbols.names.EnumSymbol;
import arcomat.symbols.names.JavaType;
import arcomat.symbols.names.OpaqueSymbol;
import arcomat.symbols.names.RangeType;
import arcomat.symbols.names.TypeSymbol;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Types of the text as types of the model. */
final class TypeLowering {
    /** What tells messages apart of which nothing is known: a text, which no model reads. */
    private static final List<Type.Attribute> NAMED =
            List.of(new Type.Attribute(OpaqueSymbol.NAME, new Type.StringType()));

    private TypeLowering() {}

    /** Type parameters must have been replaced before. */
    static Type lower(TypeSymbol type) {
        if (type instanceof BuiltinType builtin) {
            return builtin(builtin);
        }
        if (type instanceof RangeType range) {
            return new Type.IntegerType(width(range.carrier()), range.low(), range.high(), true);
        }
        return defined(type);
    }

    private static Type defined(TypeSymbol type) {
        if (type instanceof EnumSymbol enumeration) {
            return enumeration(enumeration);
        }
        return constructed(type);
    }

    /** A type of objects. */
    static Type.ClassType constructed(TypeSymbol type) {
        if (type instanceof ClassSymbol object) {
            return object(object);
        }
        return named(type);
    }

    /** A type of which nothing but its name is known. */
    private static Type.ClassType named(TypeSymbol type) {
        if (type instanceof OpaqueSymbol opaque) {
            return new Type.ClassType(opaque.qualifiedName(), NAMED);
        }
        if (type instanceof JavaType java) {
            return new Type.ClassType(java(java), NAMED);
        }
        throw new IllegalStateException("no type of the model: " + type.text());
    }

    static Type.EnumType enumeration(EnumSymbol symbol) {
        return new Type.EnumType(symbol.qualifiedName(), symbol.constants());
    }

    private static Type.ClassType object(ClassSymbol symbol) {
        List<Type.Attribute> attributes = new ArrayList<>();
        for (ClassSymbol.AttributeSymbol attribute : symbol.attributes()) {
            attributes.add(new Type.Attribute(attribute.name(), lower(attribute.type())));
        }
        return new Type.ClassType(symbol.qualifiedName(), attributes);
    }

    private static Type.JavaClass java(JavaType type) {
        return new Type.JavaClass(
                type.qualifiedName(),
                type.arguments().stream().map(TypeLowering::argument).toList());
    }

    private static Type.JavaArgument argument(JavaType.Argument argument) {
        return new Type.JavaArgument(
                argument.bound().words(),
                argument.bound() == JavaType.Bound.ANY
                        ? Optional.empty()
                        : Optional.of(lower(argument.type())));
    }

    private static Type builtin(BuiltinType type) {
        return switch (type) {
            case BOOLEAN -> new Type.BooleanType();
            case BYTE, SHORT, INTEGER, LONG -> Type.IntegerType.of(width(type));
            case CHARACTER -> new Type.CharacterType();
            case FLOAT -> new Type.RealType(true);
            case DOUBLE -> new Type.RealType(false);
            case STRING -> new Type.StringType();
        };
    }

    private static Type.Width width(BuiltinType type) {
        return switch (type) {
            case BYTE -> Type.Width.BYTE;
            case SHORT -> Type.Width.SHORT;
            case INTEGER -> Type.Width.INT;
            case LONG -> Type.Width.LONG;
            case BOOLEAN, CHARACTER, FLOAT, DOUBLE, STRING ->
                    throw new IllegalStateException("no whole numbers: " + type);
        };
    }
}
