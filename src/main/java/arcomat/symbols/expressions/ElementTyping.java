package arcomat.symbols.expressions;

import static arcomat.symbols.expressions.Problems.quoted;

import arcomat.source.ArrayNames;
import arcomat.symbols.expressions.ExpressionProblem.Kind;
import arcomat.symbols.names.TypeSymbol;
import arcomat.tree.Expression;
import arcomat.tree.Name;
import arcomat.tree.QualifiedName;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;

/** Tells which element of an array is meant: its number is known before a run. */
final class ElementTyping {
    private final ValueScope scope;
    private final Problems problems;
    private final ReferenceTyping references;
    private final Function<Expression, TypedExpression> typing;

    ElementTyping(
            ValueScope scope,
            Problems problems,
            ReferenceTyping references,
            Function<Expression, TypedExpression> typing) {
        this.scope = scope;
        this.problems = problems;
        this.references = references;
        this.typing = typing;
    }

    /** Empty for what is no array of models: then it is one of Java. */
    Optional<TypedExpression> type(Expression.Indexed node, TypeSymbol expected) {
        List<Name> names = new ArrayList<>();
        for (Expression.Indexed.Step step : node.steps()) {
            if (step.index().isPresent() && !isArray(names, step.name())) {
                return Optional.empty();
            }
            Optional<Name> name = step.index().isEmpty() ? Optional.of(step.name()) : name(step);
            if (name.isEmpty()) {
                return Optional.of(new TypedExpression.Erroneous(node, List.of()));
            }
            names.add(name.get());
        }
        QualifiedName name = new QualifiedName(node.span(), List.copyOf(names));
        return Optional.of(references.type(new Expression.Reference(node.span(), name), expected));
    }

    /** Of the values that can be named here; a part has ports. */
    private boolean isArray(List<Name> before, Name array) {
        List<String> path = new ArrayList<>(before.stream().map(Name::text).toList());
        path.add(ArrayNames.element(array.text(), 0));
        String first = String.join(".", path);
        return scope.value(first).isPresent()
                || scope.names().stream().anyMatch(name -> name.startsWith(first + "."));
    }

    private Optional<Name> name(Expression.Indexed.Step step) {
        Expression written = step.index().orElseThrow();
        TypedExpression index = typing.apply(written);
        problems.unfolding().values().add(index);
        Optional<Long> number =
                ConstantFolding.computed(index).filter(value -> value == value.intValue());
        if (number.isEmpty() && !index.type().isErroneous()) {
            problems.report(
                    Kind.DOMAIN,
                    written,
                    "%s is no whole number that is known before the run; number the elements of '%s' from 0"
                            .formatted(quoted(written), step.name()));
        }
        return number.map(
                value ->
                        new Name(
                                step.span(),
                                ArrayNames.element(step.name().text(), value.intValue())));
    }
}
