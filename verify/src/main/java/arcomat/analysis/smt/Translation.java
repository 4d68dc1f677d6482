package arcomat.analysis.smt;

import arcomat.model.Expression;
import arcomat.model.Expression.BinaryOperator;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.semantics.expression.Fault;
import arcomat.semantics.expression.Interval;
import arcomat.semantics.expression.Scope;

import de.uni_freiburg.informatik.ultimate.logic.Term;

import org.jspecify.annotations.Nullable;

import java.math.BigInteger;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * Expressions at one instant. Integers wrap around: a result that does not fit is the number that
 * does and differs by a multiple of 2 to the power of the width. What linear arithmetic cannot say,
 * a product of two variables or a real number, is replaced by an unknown value: what can never
 * happen then, never happens.
 */
final class Translation implements Expression.Cases<Term> {
    private final ConstantExpressions constants;
    private final ReadTerms at;
    private final Solver solver;
    private final Encoding codes;
    private final ModularArithmetic modular;
    private final Map<Expression, Term> known = new IdentityHashMap<>();
    private final Map<List<Object>, Term> unknown = new HashMap<>();
    private final Set<Expression.Binary> products = new LinkedHashSet<>();
    private final Set<List<Object>> learnt = new HashSet<>();
    private final Map<Expression, Term> replaced = new LinkedHashMap<>();

    Translation(ConstantExpressions constants, ReadTerms at, Solver solver, Encoding codes) {
        this.constants = constants;
        this.at = at;
        this.solver = solver;
        this.codes = codes;
        this.modular = new ModularArithmetic(at, solver);
    }

    /** The same for the same expression, however often it is asked for. */
    Term term(Expression e) {
        Term term = known.get(e);
        if (term == null) {
            term = e.match(this);
            known.put(e, term);
        }
        return term;
    }

    /** What was replaced by an unknown value; nothing where all is exact. */
    Map<Expression, Term> replaced() {
        return replaced;
    }

    /** The same for an operation on the same values: that is all which is known of it. */
    private Term unknown(Object operation, Expression e) {
        if (!codes.areExact()) {
            return at.anything(e.type());
        }
        List<Term> operands = e.operands().stream().map(this::term).toList();
        Term term =
                unknown.computeIfAbsent(
                        List.of(
                                operation,
                                e.type(),
                                isCommutative(e) ? Set.copyOf(operands) : operands),
                        each -> at.anything(e.type()));
        replaced.put(e, term);
        return term;
    }

    private static boolean isCommutative(Expression e) {
        return e instanceof Expression.Binary binary
                && binary.type().isNumber()
                && (binary.operator() == BinaryOperator.PLUS
                        || binary.operator() == BinaryOperator.MULTIPLY);
    }

    @Override
    public Term constant(Expression.Constant constant) {
        return fixed(constant.value(), constant);
    }

    @Override
    public Term parameterRead(Expression.ParameterRead read) {
        return fixed(constants.argument(read), read);
    }

    private Term fixed(Value value, Expression e) {
        return codes.isExact(e.type()) ? codes.encode(value, e.type()) : unknown(value, e);
    }

    @Override
    public Term portRead(Expression.PortRead read) {
        return at.message(read.port());
    }

    @Override
    public Term variableRead(Expression.VariableRead read) {
        return constants.isConstant(read.variable())
                ? term(read.variable().initial())
                : at.variable(read.variable());
    }

    @Override
    public Term attributeRead(Expression.AttributeRead read) {
        return unknown(read.index(), read);
    }

    @Override
    public Term portMatches(Expression.PortMatches matches) {
        Term has = at.has(matches.port());
        Expression read = new Expression.PortRead(matches.port(), matches.span());
        return matches.pattern()
                .match(
                        oneOf -> solver.and(has, oneOf(read, oneOf.values())),
                        () -> solver.not(has),
                        () -> has);
    }

    @Override
    public Term conditional(Expression.Conditional choice) {
        return codes.isExact(choice.type())
                ? solver.choose(
                        term(choice.condition()), term(choice.then()), term(choice.otherwise()))
                : unknown("choice", choice);
    }

    @Override
    public Term isIn(Expression.IsIn isIn) {
        return oneOf(isIn.element(), isIn.set());
    }

    /** Only what runs is judged. */
    @Override
    public Term judged(Expression.Judged judged) {
        throw new AssertionError(judged);
    }

    @Override
    public Term cast(Expression.Cast cast) {
        if (cast.type().equals(cast.operand().type())) {
            return term(cast.operand());
        }
        return Interval.isInteger(cast.type()) && Interval.isInteger(cast.operand().type())
                ? modular.wrapped(term(cast.operand()), cast)
                : unknown("cast", cast);
    }

    private Term oneOf(Expression element, List<Expression> set) {
        return solver.or(set.stream().map(value -> equal(element, value)).toList());
    }

    private Term equal(Expression one, Expression two) {
        boolean exact = codes.isExact(one.type()) && codes.isExact(two.type());
        if (!exact || !isAlike(one, two)) {
            Term unknown = at.anything(new Type.BooleanType());
            replaced.put(one, unknown);
            return unknown;
        }
        return one.type() instanceof Type.RealType real
                ? RealCodes.of(real).compared("=", term(one), term(two), solver)
                : solver.equal(term(one), term(two));
    }

    /** Whether both are real numbers of the same width, or neither is one. */
    private static boolean isAlike(Expression one, Expression two) {
        boolean real = one.type() instanceof Type.RealType || two.type() instanceof Type.RealType;
        return !real || one.type().equals(two.type());
    }

    @Override
    public Term unary(Expression.Unary unary) {
        Term operand = term(unary.operand());
        return switch (unary.operator()) {
            case NOT -> solver.not(operand);
            case NEGATE -> negated(operand, unary);
            case COMPLEMENT -> solver.apply("-", solver.apply("-", operand), solver.number(1));
        };
    }

    private Term negated(Term operand, Expression.Unary negation) {
        if (Interval.isInteger(negation.type())) {
            return modular.wrapped(solver.apply("-", operand), negation);
        }
        return negation.type() instanceof Type.RealType real && codes.isExact(real)
                ? RealCodes.of(real).negated(operand, solver)
                : unknown(negation.operator(), negation);
    }

    @Override
    public Term binary(Expression.Binary binary) {
        return switch (binary.operator()) {
            case EQUAL -> equal(binary.left(), binary.right());
            case NOT_EQUAL -> solver.not(equal(binary.left(), binary.right()));
            case LESS, LESS_OR_EQUAL, GREATER, GREATER_OR_EQUAL -> comparison(binary);
            case AND -> solver.and(term(binary.left()), term(binary.right()));
            case OR -> solver.or(term(binary.left()), term(binary.right()));
            case IMPLIES -> solver.or(solver.not(term(binary.left())), term(binary.right()));
            case EQUIVALENT -> solver.equal(term(binary.left()), term(binary.right()));
            default ->
                    Interval.isInteger(binary.type())
                            ? arithmetic(binary)
                            : unknown(binary.operator(), binary);
        };
    }

    /** Models write these operators as SMT-LIB does. */
    private Term comparison(Expression.Binary binary) {
        if (binary.left().type() instanceof Type.RealType real
                && codes.isExact(real)
                && isAlike(binary.left(), binary.right())) {
            return RealCodes.of(real)
                    .compared(
                            binary.operator().sign(),
                            term(binary.left()),
                            term(binary.right()),
                            solver);
        }
        return Interval.isInteger(binary.left().type()) && Interval.isInteger(binary.right().type())
                ? operation(binary)
                : unknown(binary.operator(), binary);
    }

    private Term operation(Expression.Binary binary) {
        return solver.apply(binary.operator().sign(), term(binary.left()), term(binary.right()));
    }

    private Term arithmetic(Expression.Binary binary) {
        return switch (binary.operator()) {
            case PLUS, MINUS -> modular.wrapped(operation(binary), binary);
            case MULTIPLY -> product(binary);
            case DIVIDE -> modular.wrapped(divided(binary).quotient(), binary);
            case REMAINDER -> divided(binary).rest();
            default -> throw new AssertionError(binary.operator());
        };
    }

    /** Linear where one of the factors has few values: by cases. */
    private Term product(Expression.Binary binary) {
        boolean right = !constants.few(binary.right()).isEmpty();
        Expression factor = right ? binary.right() : binary.left();
        Term other = term(right ? binary.left() : binary.right());
        List<Long> values = constants.few(factor);
        if (values.isEmpty()) {
            Term unknown = unknown(binary.operator(), binary);
            products.add(binary);
            Interval possible = Interval.of(binary);
            solver.claim(solver.between(possible.low(), unknown, possible.high()));
            return unknown;
        }
        if (values.size() == 1) {
            return modular.wrapped(solver.apply("*", solver.number(values.get(0)), other), binary);
        }
        Term product = at.defined();
        Term given = term(factor);
        for (long value : values) {
            Term multiple = solver.apply("*", solver.number(value), other);
            claim(solver.equal(given, solver.number(value)), solver.equal(product, multiple));
        }
        return modular.wrapped(product, binary);
    }

    /**
     * Claims what products really are, for the value that the left factor has in an example: then
     * they are linear.
     *
     * @return that the factors have these values; empty where there was nothing to learn
     */
    List<Term> learn(Scope scope, Value[] example) {
        List<Term> learned = new ArrayList<>();
        for (Expression.Binary each : List.copyOf(products)) {
            Value factor = factor(each, scope, example);
            if (factor != null && learnt.add(List.of(each, factor))) {
                Expression given = new Expression.Constant(factor, each.left().type(), each.span());
                Expression linear =
                        new Expression.Binary(
                                each.operator(), given, each.right(), each.type(), each.span());
                Term isGiven = solver.equal(term(each.left()), term(given));
                claim(isGiven, solver.equal(term(each), term(linear)));
                learned.add(isGiven);
            }
        }
        return learned;
    }

    private static @Nullable Value factor(Expression.Binary product, Scope scope, Value[] example) {
        try {
            return scope.value(product.left(), example);
        } catch (Fault divisionByZero) {
            return null;
        }
    }

    private record Division(Term quotient, Term rest) {}

    private Division divided(Expression.Binary binary) {
        return constants.few(binary.right()).isEmpty()
                ? new Division(someQuotient(binary), someRemainder(binary))
                : byCases(binary);
    }

    /**
     * By cases of the divisor. Java rounds towards zero: the rest has the sign of the dividend, and
     * is less than the divisor.
     */
    private Division byCases(Expression.Binary binary) {
        Term dividend = term(binary.left());
        Term divisor = term(binary.right());
        Term negative = solver.apply("<", dividend, solver.number(0));
        Term quotient = at.defined();
        Term rest = at.defined();
        for (long value : constants.few(binary.right())) {
            if (value != 0) {
                BigInteger most = BigInteger.valueOf(value).abs().subtract(BigInteger.ONE);
                Term multiple = solver.apply("*", solver.number(value), quotient);
                claim(
                        solver.equal(divisor, solver.number(value)),
                        solver.and(
                                solver.equal(dividend, solver.apply("+", multiple, rest)),
                                solver.choose(
                                        negative,
                                        solver.between(most.negate(), rest, BigInteger.ZERO),
                                        solver.between(BigInteger.ZERO, rest, most))));
            }
        }
        return new Division(quotient, rest);
    }

    /** Of a divisor with too many values: never larger than the dividend, whatever the sign. */
    private Term someQuotient(Expression.Binary binary) {
        Term quotient = unknown("quotient", binary);
        Term dividend = term(binary.left());
        Term opposite = solver.apply("-", dividend);
        solver.claim(
                solver.or(
                        isWithin(opposite, quotient, dividend),
                        isWithin(dividend, quotient, opposite)));
        return quotient;
    }

    /**
     * Of a divisor with too many values: between zero and the dividend, and closer to zero than the
     * divisor.
     */
    private Term someRemainder(Expression.Binary binary) {
        Term rest = unknown("rest", binary);
        Term dividend = term(binary.left());
        Term divisor = term(binary.right());
        Term zero = solver.number(0);
        solver.claim(solver.or(isWithin(zero, rest, dividend), isWithin(dividend, rest, zero)));
        Term opposite = solver.apply("-", divisor);
        solver.claim(
                solver.or(
                        solver.equal(divisor, zero),
                        solver.and(
                                solver.apply("<", opposite, rest),
                                solver.apply("<", rest, divisor)),
                        solver.and(
                                solver.apply("<", divisor, rest),
                                solver.apply("<", rest, opposite))));
        return rest;
    }

    private Term isWithin(Term low, Term number, Term high) {
        return solver.and(solver.apply("<=", low, number), solver.apply("<=", number, high));
    }

    private void claim(Term condition, Term consequence) {
        solver.claim(solver.or(solver.not(condition), consequence));
    }
}
