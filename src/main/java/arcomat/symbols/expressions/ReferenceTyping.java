package arcomat.symbols.expressions;

import arcomat.source.Nearest;
import arcomat.symbols.expressions.ExpressionProblem.Kind;
import arcomat.symbols.names.BuiltinType;
import arcomat.symbols.names.ClassSymbol;
import arcomat.symbols.names.EnumSymbol;
import arcomat.symbols.names.JavaType;
import arcomat.symbols.names.Resolution;
import arcomat.symbols.names.TypeSymbol;
import arcomat.tree.Expression;
import arcomat.tree.Name;
import arcomat.tree.QualifiedName;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalInt;

/** Tells what names in expressions mean: values, their attributes, constants of enumerations. */
final class ReferenceTyping {
    private static final List<String> TRUTHS = List.of("true", "false");

    private final ValueScope scope;
    private final Problems problems;

    ReferenceTyping(ValueScope scope, Problems problems) {
        this.scope = scope;
        this.problems = problems;
    }

    /** Whether an expression is a simple name without a value: at best a constant. */
    boolean isBareConstant(Expression expression) {
        return expression instanceof Expression.Reference reference
                && reference.name().isSimple()
                && scope.value(reference.name().text()).isEmpty();
    }

    TypedExpression type(Expression.Reference reference, TypeSymbol expected) {
        List<Name> parts = reference.name().parts();
        Optional<ValueSymbol> value = scope.value(parts.get(0).text());
        if (value.isPresent()) {
            return attributes(reference, value.get().read(reference), 1);
        }
        Optional<ValueSymbol> ofPart = ofPart(parts);
        if (ofPart.isPresent()) {
            return attributes(reference, ofPart.get().read(reference), 2);
        }
        return parts.size() == 1 ? bareConstant(reference, expected) : qualifiedConstant(reference);
    }

    /** Where ports of parts can be named, their names have a dot. */
    private Optional<ValueSymbol> ofPart(List<Name> parts) {
        return parts.size() < 2
                ? Optional.empty()
                : scope.value(parts.get(0).text() + "." + parts.get(1).text());
    }

    /**
     * @param named how many parts of the name the value takes
     */
    private TypedExpression attributes(
            Expression.Reference reference, TypedExpression value, int named) {
        TypedExpression current = value;
        List<Name> parts = reference.name().parts();
        for (Name part : parts.subList(named, parts.size())) {
            if (current.type().isErroneous()) {
                return new TypedExpression.Erroneous(reference, List.of(current));
            }
            int index =
                    current.type() instanceof ClassSymbol type ? indexOf(type, part.text()) : -1;
            if (index < 0) {
                return unknownAttribute(reference, current, part);
            }
            TypeSymbol type = ((ClassSymbol) current.type()).attributes().get(index).type();
            current = new TypedExpression.AttributeRead(reference, current, index, type);
        }
        return current;
    }

    private static int indexOf(ClassSymbol type, String name) {
        for (int i = 0; i < type.attributes().size(); i++) {
            if (type.attributes().get(i).name().equals(name)) {
                return i;
            }
        }
        return -1;
    }

    private TypedExpression unknownAttribute(
            Expression.Reference reference, TypedExpression value, Name part) {
        List<String> known =
                value.type() instanceof ClassSymbol type
                        ? type.attributes().stream().map(ClassSymbol.AttributeSymbol::name).toList()
                        : List.of();
        problems.report(
                Kind.UNKNOWN_ATTRIBUTE,
                at(part),
                value.type() instanceof JavaType
                        ? "nobody looks into a message of type %s, so '%s' cannot be read; %s"
                                .formatted(
                                        value.type().text(),
                                        part,
                                        "send it over a port of its own, or define a class in a"
                                                + " class diagram")
                        : "type %s has no attribute '%s'%s"
                                .formatted(
                                        value.type().text(),
                                        part,
                                        Nearest.hint(part.text(), known)),
                Nearest.to(part.text(), known));
        return new TypedExpression.Erroneous(reference, List.of(value));
    }

    private TypedExpression bareConstant(Expression.Reference reference, TypeSymbol expected) {
        String name = reference.name().text();
        if (expected instanceof EnumSymbol type) {
            OptionalInt ordinal = type.ordinal(name);
            if (ordinal.isPresent()) {
                return new TypedExpression.Constant(reference, type, ordinal.getAsInt(), false);
            }
        }
        List<String> known = new ArrayList<>(scope.names());
        if (expected instanceof EnumSymbol type) {
            known.addAll(0, type.constants());
        } else if (expected == BuiltinType.BOOLEAN
                || TRUTHS.contains(name.toLowerCase(Locale.ROOT))) {
            known.addAll(TRUTHS);
        }
        problems.report(
                Kind.UNKNOWN_NAME,
                reference,
                "'" + name + "' is not " + wanted(expected) + hint(name, known, expected),
                Nearest.to(name, known));
        return new TypedExpression.Erroneous(reference, List.of());
    }

    private static String hint(String name, List<String> known, TypeSymbol expected) {
        String hint = Nearest.hint(name, known);
        if (hint.isEmpty() && expected instanceof EnumSymbol type && isShort(type)) {
            return "; it has " + String.join(", ", type.constants());
        }
        return hint.isEmpty() ? "; declare it or correct the name" : hint;
    }

    private static boolean isShort(EnumSymbol type) {
        return !type.constants().isEmpty() && type.constants().size() <= 8;
    }

    /** What a simple name could be here; in a stream test there is nothing but constants. */
    private String wanted(TypeSymbol expected) {
        boolean values = !scope.names().isEmpty();
        if (expected instanceof EnumSymbol type) {
            String constant = "a constant of " + type.text();
            return values ? "a port, a variable, a parameter or " + constant : constant;
        }
        return values ? "a port, a variable or a parameter" : "a literal or a constant of an enum";
    }

    private TypedExpression qualifiedConstant(Expression.Reference reference) {
        Resolution<TypeSymbol> qualifier = scope.unitScope().qualifierOf(reference);
        Name last = reference.name().last();
        if (qualifier.found().orElse(null) instanceof EnumSymbol type) {
            OptionalInt ordinal = type.ordinal(last.text());
            if (ordinal.isPresent()) {
                return new TypedExpression.Constant(reference, type, ordinal.getAsInt(), true);
            }
            problems.report(
                    Kind.UNKNOWN_CONSTANT,
                    at(last),
                    "%s has no constant '%s'%s"
                            .formatted(
                                    type.text(), last, Nearest.hint(last.text(), type.constants())),
                    Nearest.to(last.text(), type.constants()));
        } else if (qualifier.isAmbiguous()) {
            problems.report(
                    Kind.AMBIGUOUS_NAME,
                    reference,
                    "several types could be meant by '" + reference.name() + "'; qualify it fully");
        } else if (qualifier.isUnknown() || qualifier.isFound()) {
            problems.report(
                    Kind.UNKNOWN_NAME,
                    reference,
                    "'%s' is neither a constant of a known enum nor an attribute of a value%s"
                            .formatted(
                                    reference.name(),
                                    Nearest.hint(
                                            reference.name().parts().get(0).text(),
                                            scope.names())));
        }
        return new TypedExpression.Erroneous(reference, List.of());
    }

    /** The reference, narrowed to one of its names. */
    private static Expression at(Name part) {
        return new Expression.Reference(part.span(), new QualifiedName(part.span(), List.of(part)));
    }
}
