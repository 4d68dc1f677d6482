package arcomat.analysis.smt;

import arcomat.model.Expression;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.semantics.expression.Interval;

import de.uni_freiburg.informatik.ultimate.logic.Term;

import java.math.BigInteger;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;

/**
 * Expressions at one instant. Integers wrap around: a result that does not fit is the number that
 * does and differs by a multiple of 2 to the power of the width. What linear arithmetic cannot say,
 * a product of two variables or a real number, is replaced by an unknown value: what can never
 * happen then, never happens.
 */
final class Translation implements Expression.Cases<Term> {
    private final ConstantExpressions constants;
    private final Instant at;
    private final Solver solver;
    private final Encoding codes;
    private final ModularArithmetic modular;
    private final Map<Expression, Term> known = new IdentityHashMap<>();

    Translation(Subject subject, Instant at, Solver solver, Encoding codes) {
        this.constants = new ConstantExpressions(subject);
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

    @Override
    public Term constant(Expression.Constant constant) {
        return fixed(constant.value(), constant.type());
    }

    @Override
    public Term parameterRead(Expression.ParameterRead read) {
        return fixed(constants.argument(read), read.type());
    }

    private Term fixed(Value value, Type type) {
        return Encoding.isExact(type) ? codes.encode(value) : at.anything(type);
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
        return at.anything(read.type());
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
        return Encoding.isExact(choice.type())
                ? solver.choose(
                        term(choice.condition()), term(choice.then()), term(choice.otherwise()))
                : at.anything(choice.type());
    }

    @Override
    public Term isIn(Expression.IsIn isIn) {
        return oneOf(isIn.element(), isIn.set());
    }

    @Override
    public Term cast(Expression.Cast cast) {
        return isInteger(cast.type()) && isInteger(cast.operand().type())
                ? modular.wrapped(term(cast.operand()), cast)
                : at.anything(cast.type());
    }

    /** Characters count as their codes. */
    static boolean isInteger(Type type) {
        return type instanceof Type.IntegerType || type instanceof Type.CharacterType;
    }

    private Term oneOf(Expression element, List<Expression> set) {
        return solver.or(set.stream().map(value -> equal(element, value)).toList());
    }

    private Term equal(Expression one, Expression two) {
        boolean exact = Encoding.isExact(one.type()) && Encoding.isExact(two.type());
        return exact ? solver.equal(term(one), term(two)) : at.anything(new Type.BooleanType());
    }

    @Override
    public Term unary(Expression.Unary unary) {
        Term operand = term(unary.operand());
        return switch (unary.operator()) {
            case NOT -> solver.not(operand);
            case NEGATE ->
                    isInteger(unary.type())
                            ? modular.wrapped(solver.apply("-", operand), unary)
                            : at.anything(unary.type());
            case COMPLEMENT -> solver.apply("-", solver.apply("-", operand), solver.number(1));
        };
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
            default -> isInteger(binary.type()) ? arithmetic(binary) : at.anything(binary.type());
        };
    }

    /** Models write these operators as SMT-LIB does. */
    private Term comparison(Expression.Binary binary) {
        return isInteger(binary.left().type()) && isInteger(binary.right().type())
                ? operation(binary)
                : at.anything(binary.type());
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
            Term unknown = at.anything(binary.type());
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
        Term quotient = at.anything(binary.type());
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
        Term rest = at.anything(binary.type());
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
