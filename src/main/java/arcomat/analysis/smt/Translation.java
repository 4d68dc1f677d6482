package arcomat.analysis.smt;

import arcomat.model.Automaton;
import arcomat.model.Expression;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.semantics.expression.Interval;

import de.uni_freiburg.informatik.ultimate.logic.Term;

import java.math.BigInteger;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Expressions at one instant. Integers wrap around: a result that does not fit is the number that
 * does and differs by a multiple of 2 to the power of the width. What linear arithmetic cannot say,
 * a product of two variables or a real number, is replaced by an unknown value: what can never
 * happen then, never happens.
 */
final class Translation {
    private final Symbols symbols;
    private final Instant at;
    private final Solver solver;
    private final Codes codes;
    private final Turns turns;
    private final Map<Expression, Term> known = new IdentityHashMap<>();

    Translation(Symbols symbols, Instant at, Solver solver, Codes codes) {
        this.symbols = symbols;
        this.at = at;
        this.solver = solver;
        this.codes = codes;
        this.turns = new Turns(at, solver);
    }

    /** The same for the same expression, however often it is asked for. */
    Term term(Expression e) {
        Term term = known.get(e);
        if (term == null) {
            term = translated(e);
            known.put(e, term);
        }
        return term;
    }

    private Term translated(Expression e) {
        Optional<Value> fixed = symbols.fixed(e).filter(value -> Codes.isExact(e.type()));
        if (fixed.isPresent()) {
            return codes.encode(fixed.get(), solver);
        }
        if (e instanceof Expression.PortRead read) {
            return at.message(read.port());
        }
        if (e instanceof Expression.VariableRead read) {
            return symbols.isConstant(read.variable())
                    ? term(read.variable().initial())
                    : at.variable(read.variable());
        }
        if (e instanceof Expression.PortMatches matches) {
            return matches(matches);
        }
        if (e instanceof Expression.Unary unary) {
            return unary(unary);
        }
        if (e instanceof Expression.Binary binary) {
            return binary(binary);
        }
        if (e instanceof Expression.Conditional choice && isSayable(choice.type())) {
            return solver.choose(
                    term(choice.condition()), term(choice.then()), term(choice.otherwise()));
        }
        if (e instanceof Expression.IsIn isIn) {
            return oneOf(isIn.element(), isIn.set());
        }
        if (e instanceof Expression.Cast cast
                && isInteger(cast.type())
                && isInteger(cast.operand().type())) {
            return turns.wrapped(term(cast.operand()), e);
        }
        return at.anything(e.type());
    }

    private static boolean isSayable(Type type) {
        return Codes.isExact(type);
    }

    /** Characters count as their codes. */
    static boolean isInteger(Type type) {
        return type instanceof Type.IntegerType || type instanceof Type.CharacterType;
    }

    Term has(Port port) {
        return at.has(port);
    }

    /** Whether a message is one of the values that are asked for. */
    Term fits(Expression.PortMatches matches, Expression value) {
        return equal(new Expression.PortRead(matches.port(), matches.span()), value);
    }

    private Term matches(Expression.PortMatches matches) {
        Term has = at.has(matches.port());
        if (matches.pattern() instanceof Automaton.Present) {
            return has;
        }
        if (matches.pattern() instanceof Automaton.Absent) {
            return solver.not(has);
        }
        Expression read = new Expression.PortRead(matches.port(), matches.span());
        return solver.and(has, oneOf(read, ((Automaton.OneOf) matches.pattern()).values()));
    }

    private Term oneOf(Expression element, List<Expression> set) {
        return solver.or(set.stream().map(value -> equal(element, value)).toList());
    }

    private Term equal(Expression one, Expression two) {
        boolean exact = Codes.isExact(one.type()) && Codes.isExact(two.type());
        return exact ? solver.equal(term(one), term(two)) : at.anything(new Type.BooleanType());
    }

    private Term unary(Expression.Unary unary) {
        Term operand = term(unary.operand());
        switch (unary.operator()) {
            case NOT:
                return solver.not(operand);
            case NEGATE:
                return isInteger(unary.type())
                        ? turns.wrapped(solver.apply("-", operand), unary)
                        : at.anything(unary.type());
            case COMPLEMENT:
                return solver.apply("-", solver.apply("-", operand), solver.number(1));
            default:
                throw new AssertionError(unary.operator());
        }
    }

    private Term binary(Expression.Binary binary) {
        switch (binary.operator()) {
            case EQUAL:
                return equal(binary.left(), binary.right());
            case NOT_EQUAL:
                return solver.not(equal(binary.left(), binary.right()));
            case LESS, LESS_OR_EQUAL, GREATER, GREATER_OR_EQUAL:
                return comparison(binary);
            case AND, OR, IMPLIES, EQUIVALENT:
                return connective(binary);
            default:
                return isInteger(binary.type()) ? arithmetic(binary) : at.anything(binary.type());
        }
    }

    private Term comparison(Expression.Binary binary) {
        if (!isInteger(binary.left().type()) || !isInteger(binary.right().type())) {
            return at.anything(binary.type());
        }
        String operator =
                switch (binary.operator()) {
                    case LESS -> "<";
                    case LESS_OR_EQUAL -> "<=";
                    case GREATER -> ">";
                    case GREATER_OR_EQUAL -> ">=";
                    default -> throw new AssertionError(binary.operator());
                };
        return solver.apply(operator, term(binary.left()), term(binary.right()));
    }

    private Term connective(Expression.Binary binary) {
        Term left = term(binary.left());
        Term right = term(binary.right());
        return switch (binary.operator()) {
            case AND -> solver.and(left, right);
            case OR -> solver.or(left, right);
            case IMPLIES -> solver.or(solver.not(left), right);
            case EQUIVALENT -> solver.equal(left, right);
            default -> throw new AssertionError(binary.operator());
        };
    }

    private Term arithmetic(Expression.Binary binary) {
        return switch (binary.operator()) {
            case PLUS -> linear("+", binary);
            case MINUS -> linear("-", binary);
            case MULTIPLY -> product(binary);
            case DIVIDE -> turns.wrapped(divided(binary).quotient(), binary);
            case REMAINDER -> divided(binary).rest();
            default -> throw new AssertionError(binary.operator());
        };
    }

    private Term linear(String operator, Expression.Binary binary) {
        return turns.wrapped(
                solver.apply(operator, term(binary.left()), term(binary.right())), binary);
    }

    /** Linear where one of the factors has few values: by cases. */
    private Term product(Expression.Binary binary) {
        boolean right = !symbols.few(binary.right()).isEmpty();
        Expression factor = right ? binary.right() : binary.left();
        Term other = term(right ? binary.left() : binary.right());
        List<Long> values = symbols.few(factor);
        if (values.isEmpty()) {
            Term unknown = at.anything(binary.type());
            Interval possible = Interval.of(binary);
            solver.claim(solver.between(possible.low(), unknown, possible.high()));
            return unknown;
        }
        if (values.size() == 1) {
            return turns.wrapped(solver.apply("*", solver.number(values.get(0)), other), binary);
        }
        Term product = at.defined();
        Term given = term(factor);
        for (long value : values) {
            Term multiple = solver.apply("*", solver.number(value), other);
            claim(solver.equal(given, solver.number(value)), solver.equal(product, multiple));
        }
        return turns.wrapped(product, binary);
    }

    private record Division(Term quotient, Term rest) {}

    private Division divided(Expression.Binary binary) {
        return symbols.few(binary.right()).isEmpty()
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
        for (long value : symbols.few(binary.right())) {
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
